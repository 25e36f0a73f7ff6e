// made from ded75564c5b8631ef628da272f8434f80ed76d9d1a432c148ba41341aa88a9b7
var instobjViewer=(()=>{var zh=Object.defineProperty;var q0=Object.getOwnPropertyDescriptor;var Y0=Object.getOwnPropertyNames;var $0=Object.prototype.hasOwnProperty;var Z0=(n,t)=>{for(var e in t)zh(n,e,{get:t[e],enumerable:!0})},J0=(n,t,e,i)=>{if(t&&typeof t=="object"||typeof t=="function")for(let s of Y0(t))!$0.call(n,s)&&s!==e&&zh(n,s,{get:()=>t[s],enumerable:!(i=q0(t,s))||i.enumerable});return n};var K0=n=>J0(zh({},"__esModule",{value:!0}),n);var h1={};Z0(h1,{render:()=>c1});var j0={i1:Int8Array,u1:Uint8Array,i2:Int16Array,u2:Uint16Array,u4:Uint32Array,f4:Float32Array};function Ga(n){return Uint8Array.from(atob(n.trim()),t=>t.charCodeAt(0))}async function er(n){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip")),e=await new Response(t).arrayBuffer(),i=new DataView(e).getUint32(0,!0),s=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,i))),r={};for(let[o,a]of Object.entries(s.arrays)){let l=a.shape.reduce((f,h)=>f*h,1),c=new j0[a.kind](e,4+i+a.at,l),u={i1:127,i2:32767}[a.kind];r[o]={data:c,shape:a.shape,step:a.step,none:a.gaps?u:null}}return{content:s,arrays:r}}function Kn(n){return Float32Array.from(n.data,t=>t===n.none?NaN:t*n.step)}function fn(n,t,e){let i=[];for(let s=t*e;s<(t+1)*e;s++)i.push(n.data[s]*n.step);return i}var Gs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Jd=0,_u=1,Kd=2;var ma=1,jd=2,lo=3,Ws=0,Un=1,gi=2,lr=0,co=1,xu=2,yu=3,vu=4,Qd=5;var cr=100,tp=101,ep=102,np=103,ip=104,sp=200,rp=201,op=202,ap=203,Su=204,Mu=205,lp=206,cp=207,hp=208,up=209,fp=210,dp=211,pp=212,mp=213,gp=214,yl=0,vl=1,Sl=2,Jr=3,Ml=4,bl=5,wl=6,El=7,Kl=0,_p=1,xp=2,Ji=0,bu=1,wu=2,Eu=3,Tu=4,Au=5,Cu=6,Ru=7;var Pu=300,hr=301,ho=302,jl=303,Ql=304,Tl=1e3,Xi=1001,Al=1002,Rn=1003,yp=1004;var ga=1005;var Dn=1006,tc=1007;var _s=1008;var jn=1009,Iu=1010,Lu=1011,uo=1012,ec=1013,Ci=1014,Ri=1015,Pi=1016,nc=1017,ic=1018,ur=1020,Du=35902,Nu=35899,Uu=1021,Fu=1022,Ii=1023,us=1026,xs=1027,Ou=1028,sc=1029,Xs=1030,rc=1031;var oc=1033,_a=33776,xa=33777,ya=33778,va=33779,ac=35840,lc=35841,cc=35842,hc=35843,uc=36196,fc=37492,dc=37496,pc=37488,mc=37489,Sa=37490,gc=37491,_c=37808,xc=37809,yc=37810,vc=37811,Sc=37812,Mc=37813,bc=37814,wc=37815,Ec=37816,Tc=37817,Ac=37818,Cc=37819,Rc=37820,Pc=37821,Ic=36492,Lc=36494,Dc=36495,Nc=36283,Uc=36284,Ma=36285,Fc=36286;var Wo=2300,Cl=2301,_l=2302,cu=2303,hu=2400,uu=2401,fu=2402;var vp=3200;var Oc=0,Sp=1,ys="",kn="srgb",Xo="srgb-linear",qo="linear",Ce="srgb";var xl=7680;var Mp=519,bp=512,wp=513,Ep=514,Bu=515,Tp=516,Ap=517,zu=518,ku=519,Vu=35044;var Gu="300 es",pi=2e3,Kr=2001;function Q0(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function t_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Yo(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Cp(){let n=Yo("canvas");return n.style.display="block",n}var _d={},jr=null;function $o(...n){let t="THREE."+n.shift();jr?jr("log",t,...n):console.log(t,...n)}function Rp(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Jt(...n){n=Rp(n);let t="THREE."+n.shift();if(jr)jr("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Qt(...n){n=Rp(n);let t="THREE."+n.shift();if(jr)jr("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Go(...n){let t=n.join(" ");t in _d||(_d[t]=!0,Jt(...n))}function Pp(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Ip={[yl]:yl,[Sl]:wl,[Ml]:Ml,[Jr]:bl,[vl]:vl,[wl]:Sl,[El]:El,[bl]:Jr},Ti=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],xd=1234567,$r=Math.PI/180,Qr=180/Math.PI;function qs(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[t&255]+Bn[t>>8&255]+"-"+Bn[t>>16&15|64]+Bn[t>>24&255]+"-"+Bn[e&63|128]+Bn[e>>8&255]+"-"+Bn[e>>16&255]+Bn[e>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function de(n,t,e){return Math.max(t,Math.min(e,n))}function Hu(n,t){return(n%t+t)%t}function e_(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function n_(n,t,e){return n!==t?(e-n)/(t-n):0}function Ho(n,t,e){return(1-e)*n+e*t}function i_(n,t,e,i){return Ho(n,t,1-Math.exp(-e*i))}function s_(n,t=1){return t-Math.abs(Hu(n,t*2)-t)}function r_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function o_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function a_(n,t){return n+Math.floor(Math.random()*(t-n+1))}function l_(n,t){return n+Math.random()*(t-n)}function c_(n){return n*(.5-Math.random())}function h_(n){n!==void 0&&(xd=n);let t=xd+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function u_(n){return n*$r}function f_(n){return n*Qr}function d_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function p_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Wu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function m_(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),f=r((t-i)/2),h=o((t-i)/2),p=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*p,a*u,a*c);break;default:Jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Bc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Xu(n,t){if(t.constructor===Float32Array)return n;let e=Bc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function qu(n,t){if(t.constructor===Float32Array)return n;let e=Bc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Yu={DEG2RAD:$r,RAD2DEG:Qr,generateUUID:qs,clamp:de,euclideanModulo:Hu,mapLinear:e_,inverseLerp:n_,lerp:Ho,damp:i_,pingpong:s_,smoothstep:r_,smootherstep:o_,randInt:a_,randFloat:l_,randFloatSpread:c_,seededRandom:h_,degToRad:u_,radToDeg:f_,isPowerOfTwo:d_,ceilPowerOfTwo:p_,floorPowerOfTwo:Wu,setQuaternionFromProperEuler:m_,normalize:qu,denormalize:Xu},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(de(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},an=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],p=r[o+1],m=r[o+2],x=r[o+3];if(f!==x||l!==h||c!==p||u!==m){let g=l*h+c*p+u*m+f*x;g<0&&(h=-h,p=-p,m=-m,x=-x,g=-g);let d=1-a;if(g<.9995){let y=Math.acos(g),P=Math.sin(y);d=Math.sin(d*y)/P,a=Math.sin(a*y)/P,l=l*d+h*a,c=c*d+p*a,u=u*d+m*a,f=f*d+x*a}else{l=l*d+h*a,c=c*d+p*a,u=u*d+m*a,f=f*d+x*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=f}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],p=r[o+2],m=r[o+3];return t[e]=a*m+u*f+l*p-c*h,t[e+1]=l*m+u*h+c*f-a*p,t[e+2]=c*m+u*p+a*h-l*f,t[e+3]=u*m-a*f-l*h-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),p=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*p*m,this._y=c*p*f-h*u*m,this._z=c*u*m+h*p*f,this._w=c*u*f-h*p*m;break;case"YXZ":this._x=h*u*f+c*p*m,this._y=c*p*f-h*u*m,this._z=c*u*m-h*p*f,this._w=c*u*f+h*p*m;break;case"ZXY":this._x=h*u*f-c*p*m,this._y=c*p*f+h*u*m,this._z=c*u*m+h*p*f,this._w=c*u*f-h*p*m;break;case"ZYX":this._x=h*u*f-c*p*m,this._y=c*p*f+h*u*m,this._z=c*u*m-h*p*f,this._w=c*u*f+h*p*m;break;case"YZX":this._x=h*u*f+c*p*m,this._y=c*p*f+h*u*m,this._z=c*u*m-h*p*f,this._w=c*u*f-h*p*m;break;case"XZY":this._x=h*u*f-c*p*m,this._y=c*p*f-h*u*m,this._z=c*u*m+h*p*f,this._w=c*u*f+h*p*m;break;default:Jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],f=e[10],h=i+a+f;if(h>0){let p=.5/Math.sqrt(h+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(de(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(yd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(yd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),f=2*(r*i-o*e);return this.x=e+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return kh.copy(this).projectOnVector(t),this.sub(kh)}reflect(t){return this.sub(kh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(de(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},kh=new G,yd=new an,ie=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],p=i[5],m=i[8],x=s[0],g=s[3],d=s[6],y=s[1],P=s[4],S=s[7],R=s[2],M=s[5],_=s[8];return r[0]=o*x+a*y+l*R,r[3]=o*g+a*P+l*M,r[6]=o*d+a*S+l*_,r[1]=c*x+u*y+f*R,r[4]=c*g+u*P+f*M,r[7]=c*d+u*S+f*_,r[2]=h*x+p*y+m*R,r[5]=h*g+p*P+m*M,r[8]=h*d+p*S+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],f=u*o-a*c,h=a*l-u*r,p=c*r-o*l,m=e*f+i*h+s*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return t[0]=f*x,t[1]=(s*c-u*i)*x,t[2]=(a*i-s*o)*x,t[3]=h*x,t[4]=(u*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=p*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Go("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Vh.makeScale(t,e)),this}rotate(t){return Go("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Vh.makeRotation(-t)),this}translate(t,e){return Go("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Vh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Vh=new ie,vd=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Sd=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function g_(){let n={enabled:!0,workingColorSpace:Xo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ce&&(s.r=hs(s.r),s.g=hs(s.g),s.b=hs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(s.r=Zr(s.r),s.g=Zr(s.g),s.b=Zr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?qo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Xo]:{primaries:t,whitePoint:i,transfer:qo,toXYZ:vd,fromXYZ:Sd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:kn},outputColorSpaceConfig:{drawingBufferColorSpace:kn}},[kn]:{primaries:t,whitePoint:i,transfer:Ce,toXYZ:vd,fromXYZ:Sd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:kn}}}),n}var _e=g_();function hs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Zr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ir,Rl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Ir===void 0&&(Ir=Yo("canvas")),Ir.width=t.width,Ir.height=t.height;let s=Ir.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Ir}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Yo("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=hs(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(hs(e[i]/255)*255):e[i]=hs(e[i]);return{data:e,width:t.width,height:t.height}}else return Jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},__=0,to=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:__++}),this.uuid=qs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Gh(s[o].image)):r.push(Gh(s[o]))}else r=Gh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Gh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Rl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Jt("Texture: Unable to serialize Texture."),{})}var x_=0,Hh=new G,Zn=class n extends Ti{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Xi,s=Xi,r=Dn,o=_s,a=Ii,l=jn,c=n.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:x_++}),this.uuid=qs(),this.name="",this.source=new to(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Hh).x}get height(){return this.source.getSize(Hh).y}get depth(){return this.source.getSize(Hh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Pu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Tl:t.x=t.x-Math.floor(t.x);break;case Xi:t.x=t.x<0?0:1;break;case Al:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Tl:t.y=t.y-Math.floor(t.y);break;case Xi:t.y=t.y<0?0:1;break;case Al:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=Pu;Zn.DEFAULT_ANISOTROPY=1;var $e=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],f=l[8],h=l[1],p=l[5],m=l[9],x=l[2],g=l[6],d=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-x)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+x)<.1&&Math.abs(m+g)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let P=(c+1)/2,S=(p+1)/2,R=(d+1)/2,M=(u+h)/4,_=(f+x)/4,b=(m+g)/4;return P>S&&P>R?P<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(P),s=M/i,r=_/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=M/s,r=b/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=b/r),this.set(i,s,r,e),this}let y=Math.sqrt((g-m)*(g-m)+(f-x)*(f-x)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(f-x)/y,this.z=(h-u)/y,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this.w=de(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this.w=de(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Pl=class extends Ti{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Dn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new $e(0,0,t,e),this.scissorTest=!1,this.viewport=new $e(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Zn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Dn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new to(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},oi=class extends Pl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Zo=class extends Zn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Xi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Il=class extends Zn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Xi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var we=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,f,h,p,m,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,f,h,p,m,x,g)}set(t,e,i,s,r,o,a,l,c,u,f,h,p,m,x,g){let d=this.elements;return d[0]=t,d[4]=e,d[8]=i,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=f,d[14]=h,d[3]=p,d[7]=m,d[11]=x,d[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Lr.setFromMatrixColumn(t,0).length(),r=1/Lr.setFromMatrixColumn(t,1).length(),o=1/Lr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let h=o*u,p=o*f,m=a*u,x=a*f;e[0]=l*u,e[4]=-l*f,e[8]=c,e[1]=p+m*c,e[5]=h-x*c,e[9]=-a*l,e[2]=x-h*c,e[6]=m+p*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,p=l*f,m=c*u,x=c*f;e[0]=h+x*a,e[4]=m*a-p,e[8]=o*c,e[1]=o*f,e[5]=o*u,e[9]=-a,e[2]=p*a-m,e[6]=x+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,p=l*f,m=c*u,x=c*f;e[0]=h-x*a,e[4]=-o*f,e[8]=m+p*a,e[1]=p+m*a,e[5]=o*u,e[9]=x-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,p=o*f,m=a*u,x=a*f;e[0]=l*u,e[4]=m*c-p,e[8]=h*c+x,e[1]=l*f,e[5]=x*c+h,e[9]=p*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,p=o*c,m=a*l,x=a*c;e[0]=l*u,e[4]=x-h*f,e[8]=m*f+p,e[1]=f,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=p*f+m,e[10]=h-x*f}else if(t.order==="XZY"){let h=o*l,p=o*c,m=a*l,x=a*c;e[0]=l*u,e[4]=-f,e[8]=c*u,e[1]=h*f+x,e[5]=o*u,e[9]=p*f-m,e[2]=m*f-p,e[6]=a*u,e[10]=x*f+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(y_,t,v_)}lookAt(t,e,i){let s=this.elements;return si.subVectors(t,e),si.lengthSq()===0&&(si.z=1),si.normalize(),Is.crossVectors(i,si),Is.lengthSq()===0&&(Math.abs(i.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Is.crossVectors(i,si)),Is.normalize(),Ha.crossVectors(si,Is),s[0]=Is.x,s[4]=Ha.x,s[8]=si.x,s[1]=Is.y,s[5]=Ha.y,s[9]=si.y,s[2]=Is.z,s[6]=Ha.z,s[10]=si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],p=i[13],m=i[2],x=i[6],g=i[10],d=i[14],y=i[3],P=i[7],S=i[11],R=i[15],M=s[0],_=s[4],b=s[8],D=s[12],A=s[1],E=s[5],N=s[9],F=s[13],I=s[2],B=s[6],X=s[10],z=s[14],ht=s[3],Y=s[7],tt=s[11],rt=s[15];return r[0]=o*M+a*A+l*I+c*ht,r[4]=o*_+a*E+l*B+c*Y,r[8]=o*b+a*N+l*X+c*tt,r[12]=o*D+a*F+l*z+c*rt,r[1]=u*M+f*A+h*I+p*ht,r[5]=u*_+f*E+h*B+p*Y,r[9]=u*b+f*N+h*X+p*tt,r[13]=u*D+f*F+h*z+p*rt,r[2]=m*M+x*A+g*I+d*ht,r[6]=m*_+x*E+g*B+d*Y,r[10]=m*b+x*N+g*X+d*tt,r[14]=m*D+x*F+g*z+d*rt,r[3]=y*M+P*A+S*I+R*ht,r[7]=y*_+P*E+S*B+R*Y,r[11]=y*b+P*N+S*X+R*tt,r[15]=y*D+P*F+S*z+R*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],f=t[6],h=t[10],p=t[14],m=t[3],x=t[7],g=t[11],d=t[15],y=l*p-c*h,P=a*p-c*f,S=a*h-l*f,R=o*p-c*u,M=o*h-l*u,_=o*f-a*u;return e*(x*y-g*P+d*S)-i*(m*y-g*R+d*M)+s*(m*P-x*R+d*_)-r*(m*S-x*M+g*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],f=t[9],h=t[10],p=t[11],m=t[12],x=t[13],g=t[14],d=t[15],y=e*a-i*o,P=e*l-s*o,S=e*c-r*o,R=i*l-s*a,M=i*c-r*a,_=s*c-r*l,b=u*x-f*m,D=u*g-h*m,A=u*d-p*m,E=f*g-h*x,N=f*d-p*x,F=h*d-p*g,I=y*F-P*N+S*E+R*A-M*D+_*b;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/I;return t[0]=(a*F-l*N+c*E)*B,t[1]=(s*N-i*F-r*E)*B,t[2]=(x*_-g*M+d*R)*B,t[3]=(h*M-f*_-p*R)*B,t[4]=(l*A-o*F-c*D)*B,t[5]=(e*F-s*A+r*D)*B,t[6]=(g*S-m*_-d*P)*B,t[7]=(u*_-h*S+p*P)*B,t[8]=(o*N-a*A+c*b)*B,t[9]=(i*A-e*N-r*b)*B,t[10]=(m*M-x*S+d*y)*B,t[11]=(f*S-u*M-p*y)*B,t[12]=(a*D-o*E-l*b)*B,t[13]=(e*E-i*D+s*b)*B,t[14]=(x*P-m*R-g*y)*B,t[15]=(u*R-f*P+h*y)*B,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,f=a+a,h=r*c,p=r*u,m=r*f,x=o*u,g=o*f,d=a*f,y=l*c,P=l*u,S=l*f,R=i.x,M=i.y,_=i.z;return s[0]=(1-(x+d))*R,s[1]=(p+S)*R,s[2]=(m-P)*R,s[3]=0,s[4]=(p-S)*M,s[5]=(1-(h+d))*M,s[6]=(g+y)*M,s[7]=0,s[8]=(m+P)*_,s[9]=(g-y)*_,s[10]=(1-(h+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Lr.set(s[0],s[1],s[2]).length(),a=Lr.set(s[4],s[5],s[6]).length(),l=Lr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bi.copy(this);let c=1/o,u=1/a,f=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=u,bi.elements[5]*=u,bi.elements[6]*=u,bi.elements[8]*=f,bi.elements[9]*=f,bi.elements[10]*=f,e.setFromRotationMatrix(bi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=pi,l=!1){let c=this.elements,u=2*r/(e-t),f=2*r/(i-s),h=(e+t)/(e-t),p=(i+s)/(i-s),m,x;if(l)m=r/(o-r),x=o*r/(o-r);else if(a===pi)m=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Kr)m=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=pi,l=!1){let c=this.elements,u=2/(e-t),f=2/(i-s),h=-(e+t)/(e-t),p=-(i+s)/(i-s),m,x;if(l)m=1/(o-r),x=o/(o-r);else if(a===pi)m=-2/(o-r),x=-(o+r)/(o-r);else if(a===Kr)m=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Lr=new G,bi=new we,y_=new G(0,0,0),v_=new G(1,1,1),Is=new G,Ha=new G,si=new G,Md=new we,bd=new an,fs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(de(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-de(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(de(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-de(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(de(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-de(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Md.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Md,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return bd.setFromEuler(this),this.setFromQuaternion(bd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};fs.DEFAULT_ORDER="XYZ";var eo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},S_=0,wd=new G,Dr=new an,rs=new we,Wa=new G,No=new G,M_=new G,b_=new an,Ed=new G(1,0,0),Td=new G(0,1,0),Ad=new G(0,0,1),Cd={type:"added"},w_={type:"removed"},Nr={type:"childadded",child:null},Wh={type:"childremoved",child:null},Nn=class n extends Ti{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:S_++}),this.uuid=qs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new G,e=new fs,i=new an,s=new G(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new we},normalMatrix:{value:new ie}}),this.matrix=new we,this.matrixWorld=new we,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new eo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Dr.setFromAxisAngle(t,e),this.quaternion.multiply(Dr),this}rotateOnWorldAxis(t,e){return Dr.setFromAxisAngle(t,e),this.quaternion.premultiply(Dr),this}rotateX(t){return this.rotateOnAxis(Ed,t)}rotateY(t){return this.rotateOnAxis(Td,t)}rotateZ(t){return this.rotateOnAxis(Ad,t)}translateOnAxis(t,e){return wd.copy(t).applyQuaternion(this.quaternion),this.position.add(wd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Ed,t)}translateY(t){return this.translateOnAxis(Td,t)}translateZ(t){return this.translateOnAxis(Ad,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(rs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Wa.copy(t):Wa.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),No.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rs.lookAt(No,Wa,this.up):rs.lookAt(Wa,No,this.up),this.quaternion.setFromRotationMatrix(rs),s&&(rs.extractRotation(s.matrixWorld),Dr.setFromRotationMatrix(rs),this.quaternion.premultiply(Dr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Cd),Nr.child=t,this.dispatchEvent(Nr),Nr.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(w_),Wh.child=t,this.dispatchEvent(Wh),Wh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),rs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),rs.multiply(t.parent.matrixWorld)),t.applyMatrix4(rs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Cd),Nr.child=t,this.dispatchEvent(Nr),Nr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,t,M_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,b_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(t.shapes,f)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),f=o(t.shapes),h=o(t.skeletons),p=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new G(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Xe=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},E_={type:"move"},no=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Xe,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Xe,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Xe,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,i),d=this._getHandJoint(c,x);g!==null&&(d.matrix.fromArray(g.transform.matrix),d.matrix.decompose(d.position,d.quaternion,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=g.radius),d.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),p=.02,m=.005;c.inputState.pinching&&h>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(E_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Xe;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Lp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ls={h:0,s:0,l:0},Xa={h:0,s:0,l:0};function Xh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var re=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=kn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=i,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=_e.workingColorSpace){if(t=Hu(t,1),e=de(e,0,1),i=de(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Xh(o,r,t+1/3),this.g=Xh(o,r,t),this.b=Xh(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=kn){function i(r){r!==void 0&&parseFloat(r)<1&&Jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=kn){let i=Lp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=hs(t.r),this.g=hs(t.g),this.b=hs(t.b),this}copyLinearToSRGB(t){return this.r=Zr(t.r),this.g=Zr(t.g),this.b=Zr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=kn){return _e.workingToColorSpace(zn.copy(this),t),Math.round(de(zn.r*255,0,255))*65536+Math.round(de(zn.g*255,0,255))*256+Math.round(de(zn.b*255,0,255))}getHexString(t=kn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(zn.copy(this),e);let i=zn.r,s=zn.g,r=zn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(zn.copy(this),e),t.r=zn.r,t.g=zn.g,t.b=zn.b,t}getStyle(t=kn){_e.workingToColorSpace(zn.copy(this),t);let e=zn.r,i=zn.g,s=zn.b;return t!==kn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ls),this.setHSL(Ls.h+t,Ls.s+e,Ls.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ls),t.getHSL(Xa);let i=Ho(Ls.h,Xa.h,e),s=Ho(Ls.s,Xa.s,e),r=Ho(Ls.l,Xa.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new re;re.NAMES=Lp;var Jo=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new fs,this.environmentIntensity=1,this.environmentRotation=new fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},wi=new G,os=new G,qh=new G,as=new G,Ur=new G,Fr=new G,Rd=new G,Yh=new G,$h=new G,Zh=new G,Jh=new $e,Kh=new $e,jh=new $e,Wi=class n{constructor(t=new G,e=new G,i=new G){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),wi.subVectors(t,e),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){wi.subVectors(s,e),os.subVectors(i,e),qh.subVectors(t,e);let o=wi.dot(wi),a=wi.dot(os),l=wi.dot(qh),c=os.dot(os),u=os.dot(qh),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,p=(c*l-a*u)*h,m=(o*u-a*l)*h;return r.set(1-p-m,m,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(o,as.y),l.addScaledVector(a,as.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Jh.setScalar(0),Kh.setScalar(0),jh.setScalar(0),Jh.fromBufferAttribute(t,e),Kh.fromBufferAttribute(t,i),jh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Jh,r.x),o.addScaledVector(Kh,r.y),o.addScaledVector(jh,r.z),o}static isFrontFacing(t,e,i,s){return wi.subVectors(i,e),os.subVectors(t,e),wi.cross(os).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wi.subVectors(this.c,this.b),os.subVectors(this.a,this.b),wi.cross(os).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Ur.subVectors(s,i),Fr.subVectors(r,i),Yh.subVectors(t,i);let l=Ur.dot(Yh),c=Fr.dot(Yh);if(l<=0&&c<=0)return e.copy(i);$h.subVectors(t,s);let u=Ur.dot($h),f=Fr.dot($h);if(u>=0&&f<=u)return e.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Ur,o);Zh.subVectors(t,r);let p=Ur.dot(Zh),m=Fr.dot(Zh);if(m>=0&&p<=m)return e.copy(r);let x=p*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(Fr,a);let g=u*m-p*f;if(g<=0&&f-u>=0&&p-m>=0)return Rd.subVectors(r,s),a=(f-u)/(f-u+(p-m)),e.copy(s).addScaledVector(Rd,a);let d=1/(g+x+h);return o=x*d,a=h*d,e.copy(i).addScaledVector(Ur,o).addScaledVector(Fr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qi=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ei.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ei.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ei.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ei):Ei.fromBufferAttribute(r,o),Ei.applyMatrix4(t.matrixWorld),this.expandByPoint(Ei);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),qa.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),qa.copy(i.boundingBox)),qa.applyMatrix4(t.matrixWorld),this.union(qa)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ei),Ei.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Uo),Ya.subVectors(this.max,Uo),Or.subVectors(t.a,Uo),Br.subVectors(t.b,Uo),zr.subVectors(t.c,Uo),Ds.subVectors(Br,Or),Ns.subVectors(zr,Br),nr.subVectors(Or,zr);let e=[0,-Ds.z,Ds.y,0,-Ns.z,Ns.y,0,-nr.z,nr.y,Ds.z,0,-Ds.x,Ns.z,0,-Ns.x,nr.z,0,-nr.x,-Ds.y,Ds.x,0,-Ns.y,Ns.x,0,-nr.y,nr.x,0];return!Qh(e,Or,Br,zr,Ya)||(e=[1,0,0,0,1,0,0,0,1],!Qh(e,Or,Br,zr,Ya))?!1:($a.crossVectors(Ds,Ns),e=[$a.x,$a.y,$a.z],Qh(e,Or,Br,zr,Ya))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ei).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ei).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ls),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ls=[new G,new G,new G,new G,new G,new G,new G,new G],Ei=new G,qa=new qi,Or=new G,Br=new G,zr=new G,Ds=new G,Ns=new G,nr=new G,Uo=new G,Ya=new G,$a=new G,ir=new G;function Qh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ir.fromArray(n,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=t.dot(ir),c=e.dot(ir),u=i.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var dn=new G,Za=new Yt,T_=0,Ln=class extends Ti{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:T_++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Vu,this.updateRanges=[],this.gpuType=Ri,this.version=0,this._normalizationScale=t!==void 0?Bc(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Za.fromBufferAttribute(this,e),Za.applyMatrix3(t),this.setXY(e,Za.x,Za.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix3(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix4(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.applyNormalMatrix(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.transformDirection(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Xu(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):qu(t,this.array)}};var Ko=class extends Ln{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var jo=class extends Ln{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Fe=class extends Ln{constructor(t,e,i){super(new Float32Array(t),e,i)}},A_=new qi,Fo=new G,tu=new G,ds=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):A_.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Fo.subVectors(t,this.center);let e=Fo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Fo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(tu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Fo.copy(t.center).add(tu)),this.expandByPoint(Fo.copy(t.center).sub(tu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},C_=0,di=new we,eu=new Nn,kr=new G,ri=new qi,Oo=new qi,Cn=new G,pn=class n extends Ti{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:C_++}),this.uuid=qs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Q0(t)?jo:Ko)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ie().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return di.makeRotationFromQuaternion(t),this.applyMatrix4(di),this}rotateX(t){return di.makeRotationX(t),this.applyMatrix4(di),this}rotateY(t){return di.makeRotationY(t),this.applyMatrix4(di),this}rotateZ(t){return di.makeRotationZ(t),this.applyMatrix4(di),this}translate(t,e,i){return di.makeTranslation(t,e,i),this.applyMatrix4(di),this}scale(t,e,i){return di.makeScale(t,e,i),this.applyMatrix4(di),this}lookAt(t){return eu.lookAt(t),eu.updateMatrix(),this.applyMatrix4(eu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(kr).negate(),this.translate(kr.x,kr.y,kr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Fe(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ds);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let i=this.boundingSphere.center;if(ri.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Oo.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(ri.min,Oo.min),ri.expandByPoint(Cn),Cn.addVectors(ri.max,Oo.max),ri.expandByPoint(Cn)):(ri.expandByPoint(Oo.min),ri.expandByPoint(Oo.max))}ri.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Cn.fromBufferAttribute(a,c),l&&(kr.fromBufferAttribute(t,c),Cn.add(kr)),s=Math.max(s,i.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ln(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new G,l[D]=new G;let u=new G,f=new G,h=new G,p=new Yt,m=new Yt,x=new Yt,g=new G,d=new G;function y(D,A,E){c[D]=c[A]=c[E]=1,u.fromBufferAttribute(i,D),f.fromBufferAttribute(i,A),h.fromBufferAttribute(i,E),p.fromBufferAttribute(r,D),m.fromBufferAttribute(r,A),x.fromBufferAttribute(r,E),f.sub(u),h.sub(u),m.sub(p),x.sub(p);let N=1/(m.x*x.y-x.x*m.y);isFinite(N)&&(g.copy(f).multiplyScalar(x.y).addScaledVector(h,-m.y).multiplyScalar(N),d.copy(h).multiplyScalar(m.x).addScaledVector(f,-x.x).multiplyScalar(N),a[D].add(g),a[A].add(g),a[E].add(g),l[D].add(d),l[A].add(d),l[E].add(d))}let P=this.groups;P.length===0&&(P=[{start:0,count:t.count}]);for(let D=0,A=P.length;D<A;++D){let E=P[D],N=E.start,F=E.count;for(let I=N,B=N+F;I<B;I+=3)y(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let S=new G,R=new G,M=new G,_=new G;function b(D){M.fromBufferAttribute(s,D),_.copy(M);let A=a[D];S.copy(A),S.sub(M.multiplyScalar(M.dot(A))).normalize(),R.crossVectors(_,A);let N=R.dot(l[D])<0?-1:1;o.setXYZW(D,S.x,S.y,S.z,N)}for(let D=0,A=i.count;D<A;++D)c[D]&&b(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ln(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,p=i.count;h<p;h++)i.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,f=new G;if(t)for(let h=0,p=t.count;h<p;h+=3){let m=t.getX(h+0),x=t.getX(h+1),g=t.getX(h+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,p=e.count;h<p;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),p=0,m=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*u;for(let d=0;d<u;d++)h[m++]=c[p++]}return new Ln(h,u,f)}if(this.index===null)return Jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],p=t(h,i);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let p=c[f];u.push(p.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,p=f.length;h<p;h++)u.push(f[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ll=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Vu,this.updateRanges=[],this.version=0,this.uuid=qs()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Pd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Pd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Pd(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=qs()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Yn=new G,Qo=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Bc(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyMatrix4(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyNormalMatrix(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.transformDirection(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){$o("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ln(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){$o("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Xu(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):qu(t,this.data.array)}},nu=new G,R_=new G,P_=new ie,In=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=nu.subVectors(i,e).cross(R_.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(nu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||P_.getNormalMatrix(t),s=this.coplanarPoint(nu).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},I_=0,Yi=class extends Ti{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:I_++}),this.uuid=qs(),this.name="",this.type="Material",this.blending=co,this.side=Ws,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Su,this.blendDst=Mu,this.blendEquation=cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new re(0,0,0),this.blendAlpha=0,this.depthFunc=Jr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Mp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xl,this.stencilZFail=xl,this.stencilZPass=xl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new re().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new In().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},io=class extends Yi{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new re(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Vr,Bo=new G,Gr=new G,Hr=new G,Wr=new Yt,zo=new Yt,Dp=new we,Ja=new G,ko=new G,Ka=new G,Id=new Yt,iu=new Yt,Ld=new Yt,ta=class extends Nn{constructor(t=new io){if(super(),this.isSprite=!0,this.type="Sprite",Vr===void 0){Vr=new pn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Ll(e,5);Vr.setIndex([0,1,2,0,2,3]),Vr.setAttribute("position",new Qo(i,3,0,!1)),Vr.setAttribute("uv",new Qo(i,2,3,!1))}this.geometry=Vr,this.material=t,this.center=new Yt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&Qt('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Gr.setFromMatrixScale(this.matrixWorld),Dp.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Hr.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Gr.multiplyScalar(-Hr.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;ja(Ja.set(-.5,-.5,0),Hr,o,Gr,s,r),ja(ko.set(.5,-.5,0),Hr,o,Gr,s,r),ja(Ka.set(.5,.5,0),Hr,o,Gr,s,r),Id.set(0,0),iu.set(1,0),Ld.set(1,1);let a=t.ray.intersectTriangle(Ja,ko,Ka,!1,Bo);if(a===null&&(ja(ko.set(-.5,.5,0),Hr,o,Gr,s,r),iu.set(0,1),a=t.ray.intersectTriangle(Ja,Ka,ko,!1,Bo),a===null))return;let l=t.ray.origin.distanceTo(Bo);l<t.near||l>t.far||e.push({distance:l,point:Bo.clone(),uv:Wi.getInterpolation(Bo,Ja,ko,Ka,Id,iu,Ld,new Yt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function ja(n,t,e,i,s,r){Wr.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(zo.x=r*Wr.x-s*Wr.y,zo.y=s*Wr.x+r*Wr.y):zo.copy(Wr),n.copy(t),n.x+=zo.x,n.y+=zo.y,n.applyMatrix4(Dp)}var cs=new G,su=new G,Qa=new G,tl=new G,Fs=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,cs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=cs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(cs.copy(this.origin).addScaledVector(this.direction,e),cs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){su.copy(t).add(e).multiplyScalar(.5),Qa.copy(e).sub(t).normalize(),tl.copy(this.origin).sub(su);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Qa),a=tl.dot(this.direction),l=-tl.dot(Qa),c=tl.lengthSq(),u=Math.abs(1-o*o),f,h,p,m;if(u>0)if(f=o*l-a,h=o*a-l,m=r*u,f>=0)if(h>=-m)if(h<=m){let x=1/u;f*=x,h*=x,p=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h<=-m?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c):h<=m?(f=0,h=Math.min(Math.max(-r,-l),r),p=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(su).addScaledVector(Qa,h),p}intersectSphere(t,e){if(t.radius<0)return null;cs.subVectors(t.center,this.origin);let i=cs.dot(this.direction),s=cs.dot(cs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(t.min.z-h.z)*f,l=(t.max.z-h.z)*f):(a=(t.max.z-h.z)*f,l=(t.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,cs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=t.x-o.x,h=t.y-o.y,p=t.z-o.z,m=e.x-o.x,x=e.y-o.y,g=e.z-o.z,d=i.x-o.x,y=i.y-o.y,P=i.z-o.z,S=Math.abs(l),R=Math.abs(c),M=Math.abs(u),_,b,D,A,E,N,F,I,B,X,z,ht;if(S>=R&&S>=M?(D=l,N=f,B=m,ht=d,l>=0?(_=c,b=u,A=h,E=p,F=x,I=g,X=y,z=P):(_=u,b=c,A=p,E=h,F=g,I=x,X=P,z=y)):R>=M?(D=c,N=h,B=x,ht=y,c>=0?(_=u,b=l,A=p,E=f,F=g,I=m,X=P,z=d):(_=l,b=u,A=f,E=p,F=m,I=g,X=d,z=P)):(D=u,N=p,B=g,ht=P,u>=0?(_=l,b=c,A=f,E=h,F=m,I=x,X=d,z=y):(_=c,b=l,A=h,E=f,F=x,I=m,X=y,z=d)),D===0)return null;let Y=_/D,tt=b/D,rt=1/D,Q=A-Y*N,st=E-tt*N,$=F-Y*B,ft=I-tt*B,it=X-Y*ht,gt=z-tt*ht,mt=it*ft-gt*$,W=Q*gt-st*it,nt=$*st-ft*Q;if(s){if(mt<0||W<0||nt<0)return null}else if((mt<0||W<0||nt<0)&&(mt>0||W>0||nt>0))return null;let lt=mt+W+nt;if(lt===0)return null;let Dt=rt*(mt*N+W*B+nt*ht);return(lt>0?Dt<0:Dt>0)?null:this.at(Dt/lt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Os=class extends Yi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new re(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=Kl,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Dd=new we,sr=new Fs,el=new ds,Nd=new G,nl=new G,il=new G,sl=new G,ru=new G,rl=new G,Ud=new G,ol=new G,Ee=class extends Nn{constructor(t=new pn,e=new Os){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){rl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(ru.fromBufferAttribute(f,t),o?rl.addScaledVector(ru,u):rl.addScaledVector(ru.sub(e),u))}e.add(rl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),el.copy(i.boundingSphere),el.applyMatrix4(r),sr.copy(t.ray).recast(t.near),!(el.containsPoint(sr.origin)===!1&&(sr.intersectSphere(el,Nd)===null||sr.origin.distanceToSquared(Nd)>(t.far-t.near)**2))&&(Dd.copy(r).invert(),sr.copy(t.ray).applyMatrix4(Dd),!(i.boundingBox!==null&&sr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,sr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=h.length;m<x;m++){let g=h[m],d=o[g.materialIndex],y=Math.max(g.start,p.start),P=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let S=y,R=P;S<R;S+=3){let M=a.getX(S),_=a.getX(S+1),b=a.getX(S+2);s=al(this,d,t,i,c,u,f,M,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let g=m,d=x;g<d;g+=3){let y=a.getX(g),P=a.getX(g+1),S=a.getX(g+2);s=al(this,o,t,i,c,u,f,y,P,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=h.length;m<x;m++){let g=h[m],d=o[g.materialIndex],y=Math.max(g.start,p.start),P=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let S=y,R=P;S<R;S+=3){let M=S,_=S+1,b=S+2;s=al(this,d,t,i,c,u,f,M,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let g=m,d=x;g<d;g+=3){let y=g,P=g+1,S=g+2;s=al(this,o,t,i,c,u,f,y,P,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function L_(n,t,e,i,s,r,o,a){let l;if(t.side===Un?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ws,a),l===null)return null;ol.copy(a),ol.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ol);return c<e.near||c>e.far?null:{distance:c,point:ol.clone(),object:n}}function al(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,nl),n.getVertexPosition(l,il),n.getVertexPosition(c,sl);let u=L_(n,t,e,i,nl,il,sl,Ud);if(u){let f=new G;Wi.getBarycoord(Ud,nl,il,sl,f),s&&(u.uv=Wi.getInterpolatedAttribute(s,a,l,c,f,new Yt)),r&&(u.uv1=Wi.getInterpolatedAttribute(r,a,l,c,f,new Yt)),o&&(u.normal=Wi.getInterpolatedAttribute(o,a,l,c,f,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};Wi.getNormal(nl,il,sl,h.normal),u.face=h,u.barycoord=f}return u}var so=class extends Zn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Rn,u=Rn,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rr=new ds,D_=new Yt(.5,.5),ll=new G,Bs=class{constructor(t=new In,e=new In,i=new In,s=new In,r=new In,o=new In){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=pi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],p=r[7],m=r[8],x=r[9],g=r[10],d=r[11],y=r[12],P=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,p-u,d-m,R-y).normalize(),s[1].setComponents(c+o,p+u,d+m,R+y).normalize(),s[2].setComponents(c+a,p+f,d+x,R+P).normalize(),s[3].setComponents(c-a,p-f,d-x,R-P).normalize(),i)s[4].setComponents(l,h,g,S).normalize(),s[5].setComponents(c-l,p-h,d-g,R-S).normalize();else if(s[4].setComponents(c-l,p-h,d-g,R-S).normalize(),e===pi)s[5].setComponents(c+l,p+h,d+g,R+S).normalize();else if(e===Kr)s[5].setComponents(l,h,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(t){rr.center.set(0,0,0);let e=D_.distanceTo(t.center);return rr.radius=.7071067811865476+e,rr.applyMatrix4(t.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ll.x=s.normal.x>0?t.max.x:t.min.x,ll.y=s.normal.y>0?t.max.y:t.min.y,ll.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ll)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Fd=new we,Dl=class n{constructor(){this.coordinateSystem=pi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Fd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Bs),i[s].setFromProjectionMatrix(Fd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Bs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var mi=class extends Yi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new re(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Nl=new G,Ul=new G,Od=new we,Vo=new Fs,cl=new ds,ou=new G,Bd=new G,ro=class extends Nn{constructor(t=new pn,e=new mi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Nl.fromBufferAttribute(e,s-1),Ul.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Nl.distanceTo(Ul);t.setAttribute("lineDistance",new Fe(i,1))}else Jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),cl.copy(i.boundingSphere),cl.applyMatrix4(s),cl.radius+=r,t.ray.intersectsSphere(cl)===!1)return;Od.copy(s).invert(),Vo.copy(t.ray).applyMatrix4(Od);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let x=p,g=m-1;x<g;x+=c){let d=u.getX(x),y=u.getX(x+1),P=hl(this,t,Vo,l,d,y,x);P&&e.push(P)}if(this.isLineLoop){let x=u.getX(m-1),g=u.getX(p),d=hl(this,t,Vo,l,x,g,m-1);d&&e.push(d)}}else{let p=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let x=p,g=m-1;x<g;x+=c){let d=hl(this,t,Vo,l,x,x+1,x);d&&e.push(d)}if(this.isLineLoop){let x=hl(this,t,Vo,l,m-1,p,m-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function hl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Nl.fromBufferAttribute(a,s),Ul.fromBufferAttribute(a,r),e.distanceSqToSegment(Nl,Ul,ou,Bd)>i)return;ou.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ou);if(!(c<t.near||c>t.far))return{distance:c,point:Bd.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var zd=new G,kd=new G,ps=class extends ro{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)zd.fromBufferAttribute(e,s),kd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+zd.distanceTo(kd);t.setAttribute("lineDistance",new Fe(i,1))}else Jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ea=class extends Zn{constructor(t=[],e=hr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},na=class extends Zn{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var ms=class extends Zn{constructor(t,e,i=Ci,s,r,o,a=Rn,l=Rn,c,u=us,f=1){if(u!==us&&u!==xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new to(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ia=class extends ms{constructor(t,e=Ci,i=hr,s,r,o=Rn,a=Rn,l,c=us){let u={width:t,height:t,depth:1},f=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},sa=class extends Zn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ai=class n extends pn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,p=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Fe(c,3)),this.setAttribute("normal",new Fe(u,3)),this.setAttribute("uv",new Fe(f,2));function m(x,g,d,y,P,S,R,M,_,b,D){let A=S/_,E=R/b,N=S/2,F=R/2,I=M/2,B=_+1,X=b+1,z=0,ht=0,Y=new G;for(let tt=0;tt<X;tt++){let rt=tt*E-F;for(let Q=0;Q<B;Q++){let st=Q*A-N;Y[x]=st*y,Y[g]=rt*P,Y[d]=I,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[g]=0,Y[d]=M>0?1:-1,u.push(Y.x,Y.y,Y.z),f.push(Q/_),f.push(1-tt/b),z+=1}}for(let tt=0;tt<b;tt++)for(let rt=0;rt<_;rt++){let Q=h+rt+B*tt,st=h+rt+B*(tt+1),$=h+(rt+1)+B*(tt+1),ft=h+(rt+1)+B*tt;l.push(Q,st,ft),l.push(st,$,ft),ht+=6}a.addGroup(p,ht,D),p+=ht,h+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var $i=class n extends pn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],p=[],m=0,x=[],g=i/2,d=0;y(),o===!1&&(t>0&&P(!0),e>0&&P(!1)),this.setIndex(u),this.setAttribute("position",new Fe(f,3)),this.setAttribute("normal",new Fe(h,3)),this.setAttribute("uv",new Fe(p,2));function y(){let S=new G,R=new G,M=0,_=(e-t)/i;for(let b=0;b<=r;b++){let D=[],A=b/r,E=A*(e-t)+t;for(let N=0;N<=s;N++){let F=N/s,I=F*l+a,B=Math.sin(I),X=Math.cos(I);R.x=E*B,R.y=-A*i+g,R.z=E*X,f.push(R.x,R.y,R.z),S.set(B,_,X).normalize(),h.push(S.x,S.y,S.z),p.push(F,1-A),D.push(m++)}x.push(D)}for(let b=0;b<s;b++)for(let D=0;D<r;D++){let A=x[D][b],E=x[D+1][b],N=x[D+1][b+1],F=x[D][b+1];(t>0||D!==0)&&(u.push(A,E,F),M+=3),(e>0||D!==r-1)&&(u.push(E,N,F),M+=3)}c.addGroup(d,M,0),d+=M}function P(S){let R=m,M=new Yt,_=new G,b=0,D=S===!0?t:e,A=S===!0?1:-1;for(let N=1;N<=s;N++)f.push(0,g*A,0),h.push(0,A,0),p.push(.5,.5),m++;let E=m;for(let N=0;N<=s;N++){let I=N/s*l+a,B=Math.cos(I),X=Math.sin(I);_.x=D*X,_.y=g*A,_.z=D*B,f.push(_.x,_.y,_.z),h.push(0,A,0),M.x=B*.5+.5,M.y=X*.5*A+.5,p.push(M.x,M.y),m++}for(let N=0;N<s;N++){let F=R+N,I=E+N;S===!0?u.push(I,I+1,F):u.push(I+1,I,F),b+=3}c.addGroup(d,b,S===!0?1:2),d+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ra=class n extends $i{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var ul=new G,fl=new G,au=new G,dl=new Wi,or=class extends pn{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos($r*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],f=new Array(3),h=new Map,p=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:x,b:g,c:d}=dl;if(x.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),dl.getNormal(au),f[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,f[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,f[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let y=0;y<3;y++){let P=(y+1)%3,S=f[y],R=f[P],M=dl[u[y]],_=dl[u[P]],b=`${S}_${R}`,D=`${R}_${S}`,A=h.get(D);A?(au.dot(A.normal)<=r&&(p.push(M.x,M.y,M.z),p.push(_.x,_.y,_.z)),h.set(D,null)):h.has(b)||h.set(b,{index0:c[y],index1:c[P],normal:au.clone()})}}for(let m of h.values())if(m){let{index0:x,index1:g}=m;ul.fromBufferAttribute(a,x),fl.fromBufferAttribute(a,g),p.push(ul.x,ul.y,ul.z),p.push(fl.x,fl.y,fl.z)}this.setAttribute("position",new Fe(p,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var oa=class n extends pn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=t/a,h=e/l,p=[],m=[],x=[],g=[];for(let d=0;d<u;d++){let y=d*h-o;for(let P=0;P<c;P++){let S=P*f-r;m.push(S,-y,0),x.push(0,0,1),g.push(P/a),g.push(1-d/l)}}for(let d=0;d<l;d++)for(let y=0;y<a;y++){let P=y+c*d,S=y+c*(d+1),R=y+1+c*(d+1),M=y+1+c*d;p.push(P,S,M),p.push(S,R,M)}this.setIndex(p),this.setAttribute("position",new Fe(m,3)),this.setAttribute("normal",new Fe(x,3)),this.setAttribute("uv",new Fe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var ar=class n extends pn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new G,h=new G,p=[],m=[],x=[],g=[];for(let d=0;d<=i;d++){let y=[],P=d/i,S=o+P*a,R=t*Math.cos(S),M=Math.sqrt(t*t-R*R),_=0;d===0&&o===0?_=.5/e:d===i&&l===Math.PI&&(_=-.5/e);for(let b=0;b<=e;b++){let D=b/e,A=s+D*r;f.x=-M*Math.cos(A),f.y=R,f.z=M*Math.sin(A),m.push(f.x,f.y,f.z),h.copy(f).normalize(),x.push(h.x,h.y,h.z),g.push(D+_,1-P),y.push(c++)}u.push(y)}for(let d=0;d<i;d++)for(let y=0;y<e;y++){let P=u[d][y+1],S=u[d][y],R=u[d+1][y],M=u[d+1][y+1];(d!==0||o>0)&&p.push(P,S,M),(d!==i-1||l<Math.PI)&&p.push(S,R,M)}this.setIndex(p),this.setAttribute("position",new Fe(m,3)),this.setAttribute("normal",new Fe(x,3)),this.setAttribute("uv",new Fe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function fr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Vd(s))s.isRenderTargetTexture?(Jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Vd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Vn(n){let t={};for(let e=0;e<n.length;e++){let i=fr(n[e]);for(let s in i)t[s]=i[s]}return t}function Vd(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function N_(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function $u(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var Np={clone:fr,merge:Vn},U_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,F_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Zi=class extends Yi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=U_,this.fragmentShader=F_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=fr(t.uniforms),this.uniformsGroups=N_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new re().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new $e().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ie().fromArray(s.value);break;case"m4":this.uniforms[i].value=new we().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Fl=class extends Zi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var mn=class extends Yi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new re(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new re(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Oc,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=Kl,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Ol=class extends Yi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=vp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Bl=class extends Yi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Xr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function pl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var zs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},zl=class extends zs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:hu,endingEnd:hu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case uu:r=t,a=2*e-i;break;case fu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case uu:o=t,l=2*i-e;break;case fu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,p=this._weightNext,m=(i-e)/(s-e),x=m*m,g=x*m,d=-h*g+2*h*x-h*m,y=(1+h)*g+(-1.5-2*h)*x+(-.5+h)*m+1,P=(-1-p)*g+(1.5+p)*x+.5*m,S=p*g-p*x;for(let R=0;R!==a;++R)r[R]=d*o[u+R]+y*o[c+R]+P*o[l+R]+S*o[f+R];return r}},kl=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Vl=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Gl=class extends zs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let m=(i-e)/(s-e),x=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*m;return r}let h=a*2,p=t-1;for(let m=0;m!==a;++m){let x=o[c+m],g=o[l+m],d=p*h+m*2,y=f[d],P=f[d+1],S=t*h+m*2,R=u[S],M=u[S+1],_=B_(i,e,y,R,s);r[m]=Up(_,x,P,M,g)}return r}};function Up(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function O_(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function B_(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Up(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=O_(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ai=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Xr(e,this.TimeBufferType),this.values=Xr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Xr(t.times,Array),values:Xr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),pl(t.settings)&&(i.settings={inTangents:Xr(t.settings.inTangents,Array),outTangents:Xr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Vl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new kl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new zl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Gl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Wo:e=this.InterpolantFactoryMethodDiscrete;break;case Cl:e=this.InterpolantFactoryMethodLinear;break;case _l:e=this.InterpolantFactoryMethodSmooth;break;case cu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Jt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Wo;case this.InterpolantFactoryMethodLinear:return Cl;case this.InterpolantFactoryMethodSmooth:return _l;case this.InterpolantFactoryMethodBezier:return cu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;pl(this.settings)&&(Gd(this.settings.inTangents,t),Gd(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;pl(this.settings)&&(Hd(this.settings.inTangents,t),Hd(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Qt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Qt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&t_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===_l,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let f=a*i,h=f-i,p=f+i;for(let m=0;m!==i;++m){let x=e[f+m];if(x!==e[h+m]||x!==e[p+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let f=a*i,h=o*i;for(let p=0;p!==i;++p)e[h+p]=e[f+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,pl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Gd(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Hd(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ai.prototype.ValueTypeName="";ai.prototype.TimeBufferType=Float32Array;ai.prototype.ValueBufferType=Float32Array;ai.prototype.DefaultInterpolation=Cl;var ks=class extends ai{constructor(t,e,i){super(t,e,i)}};ks.prototype.ValueTypeName="bool";ks.prototype.ValueBufferType=Array;ks.prototype.DefaultInterpolation=Wo;ks.prototype.InterpolantFactoryMethodLinear=void 0;ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Hl=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}};Hl.prototype.ValueTypeName="color";var Wl=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}};Wl.prototype.ValueTypeName="number";var Xl=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)an.slerpFlat(r,0,o,c-a,o,c,l);return r}},aa=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Xl(this.times,this.values,this.getValueSize(),t)}};aa.prototype.ValueTypeName="quaternion";aa.prototype.InterpolantFactoryMethodSmooth=void 0;var Vs=class extends ai{constructor(t,e,i){super(t,e,i)}};Vs.prototype.ValueTypeName="string";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=Wo;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var ql=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}};ql.prototype.ValueTypeName="vector";var Yl=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let p=c[f],m=c[f+1];if(p.global&&(p.lastIndex=0),p.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Fp=new Yl,$l=class{constructor(t){this.manager=t!==void 0?t:Fp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};$l.DEFAULT_MATERIAL_NAME="__DEFAULT";var la=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new re(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var lu=new we,Wd=new G,Xd=new G,Zl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=jn,this.map=null,this.mapPass=null,this.matrix=new we,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Bs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new $e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Wd.setFromMatrixPosition(t.matrixWorld),e.position.copy(Wd),Xd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Xd),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){lu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(lu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Kr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(lu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},ml=new G,gl=new an,Hi=new G,ca=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new we,this.projectionMatrix=new we,this.projectionMatrixInverse=new we,this.coordinateSystem=pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ml,gl,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ml,gl,Hi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ml,gl,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ml,gl,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new G,qd=new Yt,Yd=new Yt,$n=class extends ca{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Qr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan($r*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Qr*2*Math.atan(Math.tan($r*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Us.x,Us.y).multiplyScalar(-t/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Us.x,Us.y).multiplyScalar(-t/Us.z)}getViewSize(t,e){return this.getViewBounds(t,qd,Yd),e.subVectors(Yd,qd)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan($r*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ha=class extends ca{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},du=class extends Zl{constructor(){super(new ha(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ua=class extends la{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new du}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},fa=class extends la{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var qr=-90,Yr=1,oo=class extends Nn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(qr,Yr,t,e);s.layers=this.layers,this.add(s);let r=new $n(qr,Yr,t,e);r.layers=this.layers,this.add(r);let o=new $n(qr,Yr,t,e);o.layers=this.layers,this.add(o);let a=new $n(qr,Yr,t,e);a.layers=this.layers,this.add(a);let l=new $n(qr,Yr,t,e);l.layers=this.layers,this.add(l);let c=new $n(qr,Yr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===pi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Kr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=t.getRenderTarget(),h=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(f,h,p),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Jl=class extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Zu="\\[\\]\\.:\\/",z_=new RegExp("["+Zu+"]","g"),Ju="[^"+Zu+"]",k_="[^"+Zu.replace("\\.","")+"]",V_=/((?:WC+[\/:])*)/.source.replace("WC",Ju),G_=/(WCOD+)?/.source.replace("WCOD",k_),H_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ju),W_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ju),X_=new RegExp("^"+V_+G_+H_+W_+"$"),q_=["material","materials","bones","map"],pu=class{constructor(t,e,i){let s=i||We.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},We=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(z_,"")}static parseTrackName(t){let e=X_.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);q_.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Qt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Qt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Qt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Qt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Qt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Qt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};We.Composite=pu;We.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};We.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};We.prototype.GetterByBindingType=[We.prototype._getValue_direct,We.prototype._getValue_array,We.prototype._getValue_arrayElement,We.prototype._getValue_toArray];We.prototype.SetterByBindingTypeAndVersioning=[[We.prototype._setValue_direct,We.prototype._setValue_direct_setNeedsUpdate,We.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[We.prototype._setValue_array,We.prototype._setValue_array_setNeedsUpdate,We.prototype._setValue_array_setMatrixWorldNeedsUpdate],[We.prototype._setValue_arrayElement,We.prototype._setValue_arrayElement_setNeedsUpdate,We.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[We.prototype._setValue_fromArray,We.prototype._setValue_fromArray_setNeedsUpdate,We.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var d1=new Float32Array(1);var $d=new we,gs=class{constructor(t,e,i=0,s=1/0){this.ray=new Fs(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new eo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Qt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return $d.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4($d),this}intersectObject(t,e=!0,i=[]){return mu(t,this,i,e),i.sort(Zd),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)mu(t[s],this,i,e);return i.sort(Zd),i}};function Zd(n,t){return n.distance-t.distance}function mu(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)mu(r[o],t,e,!0)}}var ao=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=de(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(de(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var gu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var da=class extends ps{constructor(t=10,e=10,i=4473924,s=8947848){i=new re(i),s=new re(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let h=0,p=0,m=-a;h<=e;h++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let x=h===r?i:s;x.toArray(c,p),p+=3,x.toArray(c,p),p+=3,x.toArray(c,p),p+=3,x.toArray(c,p),p+=3}let u=new pn;u.setAttribute("position",new Fe(l,3)),u.setAttribute("color",new Fe(c,3));let f=new mi({vertexColors:!0,toneMapped:!1});super(u,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var pa=class extends Ti{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Ku(n,t,e,i){let s=Y_(i);switch(e){case Uu:return n*t;case Ou:return n*t/s.components*s.byteLength;case sc:return n*t/s.components*s.byteLength;case Xs:return n*t*2/s.components*s.byteLength;case rc:return n*t*2/s.components*s.byteLength;case Fu:return n*t*3/s.components*s.byteLength;case Ii:return n*t*4/s.components*s.byteLength;case oc:return n*t*4/s.components*s.byteLength;case _a:case xa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ya:case va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case lc:case hc:return Math.max(n,16)*Math.max(t,8)/4;case ac:case cc:return Math.max(n,8)*Math.max(t,8)/2;case uc:case fc:case pc:case mc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case dc:case Sa:case gc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case _c:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case xc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case yc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case vc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Sc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Mc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case bc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case wc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Ec:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Tc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Ac:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Cc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Rc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Pc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Ic:case Lc:case Dc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Nc:case Uc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ma:case Fc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Y_(n){switch(n){case jn:case Iu:return{byteLength:1,components:1};case uo:case Lu:case Pi:return{byteLength:2,components:1};case nc:case ic:return{byteLength:2,components:4};case Ci:case ec:case Ri:return{byteLength:4,components:1};case Du:case Nu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function sm(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Z_(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((p,m)=>p.start-m.start);let h=0;for(let p=1;p<f.length;p++){let m=f[h],x=f[p];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++h,f[h]=x)}f.length=h+1;for(let p=0,m=f.length;p<m;p++){let x=f[p];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var J_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,K_=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,j_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Q_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ex=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,nx=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ix=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,sx=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,rx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ox=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ax=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,lx=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,cx=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,hx=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ux=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,fx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,dx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,px=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,mx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,gx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,_x=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,xx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,yx=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,vx=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Sx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Mx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,bx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,wx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ex="gl_FragColor = linearToOutputTexel( gl_FragColor );",Tx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ax=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Cx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Rx=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Px=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ix=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Lx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Dx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Nx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Ux=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Fx=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Ox=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Bx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,zx=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,kx=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Vx=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Gx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Hx=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Wx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Xx=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,qx=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Yx=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,$x=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Zx=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Jx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Kx=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,jx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Qx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ty=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ey=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ny=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,iy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,sy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,ry=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,oy=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ay=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ly=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,cy=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,hy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uy=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,fy=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,dy=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,py=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,my=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_y=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,xy=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,yy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,vy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Sy=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,My=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,by=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,wy=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Ey=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ty=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Ay=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Cy=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Ry=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Py=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Iy=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Ly=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Dy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Ny=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Uy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Fy=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Oy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,By=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,zy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ky=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Vy=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Gy=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Hy=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Wy=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Xy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Yy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,$y=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Zy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Jy=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ky=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jy=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Qy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ev=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,nv=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,iv=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,sv=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,rv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ov=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,av=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,lv=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cv=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,hv=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uv=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,fv=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dv=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,pv=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mv=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,gv=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,_v=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,xv=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yv=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,vv=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Sv=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mv=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bv=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,wv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ev=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Tv=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Av=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Cv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ce={alphahash_fragment:J_,alphahash_pars_fragment:K_,alphamap_fragment:j_,alphamap_pars_fragment:Q_,alphatest_fragment:tx,alphatest_pars_fragment:ex,aomap_fragment:nx,aomap_pars_fragment:ix,batching_pars_vertex:sx,batching_vertex:rx,begin_vertex:ox,beginnormal_vertex:ax,bsdfs:lx,iridescence_fragment:cx,bumpmap_pars_fragment:hx,clipping_planes_fragment:ux,clipping_planes_pars_fragment:fx,clipping_planes_pars_vertex:dx,clipping_planes_vertex:px,color_fragment:mx,color_pars_fragment:gx,color_pars_vertex:_x,color_vertex:xx,common:yx,defaultnormal_vertex:vx,displacementmap_pars_vertex:Sx,displacementmap_vertex:Mx,emissivemap_fragment:bx,emissivemap_pars_fragment:wx,colorspace_fragment:Ex,colorspace_pars_fragment:Tx,envmap_fragment:Ax,envmap_common_pars_fragment:Cx,envmap_pars_fragment:Rx,envmap_pars_vertex:Px,envmap_physical_pars_fragment:Vx,envmap_vertex:Ix,fog_vertex:Lx,fog_pars_vertex:Dx,fog_fragment:Nx,fog_pars_fragment:Ux,gradientmap_pars_fragment:Fx,lightmap_pars_fragment:Ox,lights_lambert_fragment:Bx,lights_lambert_pars_fragment:zx,lights_pars_begin:kx,lights_toon_fragment:Gx,lights_toon_pars_fragment:Hx,lights_phong_fragment:Wx,lights_phong_pars_fragment:Xx,lights_physical_fragment:qx,lights_physical_pars_fragment:Yx,lights_fragment_begin:$x,lights_fragment_maps:Zx,lights_fragment_end:Jx,lightprobes_pars_fragment:Kx,logdepthbuf_fragment:jx,logdepthbuf_pars_fragment:Qx,logdepthbuf_pars_vertex:ty,logdepthbuf_vertex:ey,map_fragment:ny,map_pars_fragment:iy,map_particle_fragment:sy,map_particle_pars_fragment:ry,metalnessmap_fragment:oy,metalnessmap_pars_fragment:ay,morphinstance_vertex:ly,morphcolor_vertex:cy,morphnormal_vertex:hy,morphtarget_pars_vertex:uy,morphtarget_vertex:fy,normal_fragment_begin:dy,normal_fragment_maps:py,normal_pars_fragment:my,normal_pars_vertex:gy,normal_vertex:_y,normalmap_pars_fragment:xy,clearcoat_normal_fragment_begin:yy,clearcoat_normal_fragment_maps:vy,clearcoat_pars_fragment:Sy,iridescence_pars_fragment:My,opaque_fragment:by,packing:wy,premultiplied_alpha_fragment:Ey,project_vertex:Ty,dithering_fragment:Ay,dithering_pars_fragment:Cy,roughnessmap_fragment:Ry,roughnessmap_pars_fragment:Py,shadowmap_pars_fragment:Iy,shadowmap_pars_vertex:Ly,shadowmap_vertex:Dy,shadowmask_pars_fragment:Ny,skinbase_vertex:Uy,skinning_pars_vertex:Fy,skinning_vertex:Oy,skinnormal_vertex:By,specularmap_fragment:zy,specularmap_pars_fragment:ky,tonemapping_fragment:Vy,tonemapping_pars_fragment:Gy,transmission_fragment:Hy,transmission_pars_fragment:Wy,uv_pars_fragment:Xy,uv_pars_vertex:qy,uv_vertex:Yy,worldpos_vertex:$y,background_vert:Zy,background_frag:Jy,backgroundCube_vert:Ky,backgroundCube_frag:jy,cube_vert:Qy,cube_frag:tv,depth_vert:ev,depth_frag:nv,distance_vert:iv,distance_frag:sv,equirect_vert:rv,equirect_frag:ov,linedashed_vert:av,linedashed_frag:lv,meshbasic_vert:cv,meshbasic_frag:hv,meshlambert_vert:uv,meshlambert_frag:fv,meshmatcap_vert:dv,meshmatcap_frag:pv,meshnormal_vert:mv,meshnormal_frag:gv,meshphong_vert:_v,meshphong_frag:xv,meshphysical_vert:yv,meshphysical_frag:vv,meshtoon_vert:Sv,meshtoon_frag:Mv,points_vert:bv,points_frag:wv,shadow_vert:Ev,shadow_frag:Tv,sprite_vert:Av,sprite_frag:Cv},Ut={common:{diffuse:{value:new re(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new re(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new re(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new re(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},ji={basic:{uniforms:Vn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:Vn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new re(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:Vn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new re(0)},specular:{value:new re(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:Vn([Ut.common,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.roughnessmap,Ut.metalnessmap,Ut.fog,Ut.lights,{emissive:{value:new re(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:Vn([Ut.common,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.gradientmap,Ut.fog,Ut.lights,{emissive:{value:new re(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:Vn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:Vn([Ut.points,Ut.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:Vn([Ut.common,Ut.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:Vn([Ut.common,Ut.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:Vn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:Vn([Ut.sprite,Ut.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:Vn([Ut.common,Ut.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:Vn([Ut.lights,Ut.fog,{color:{value:new re(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};ji.physical={uniforms:Vn([ji.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ie},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new re(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new re(0)},specularColor:{value:new re(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var zc={r:0,b:0,g:0},Rv=new we,rm=new ie;rm.set(-1,0,0,0,1,0,0,0,1);function Pv(n,t,e,i,s,r){let o=new re(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function p(y){let P=y.isScene===!0?y.background:null;if(P&&P.isTexture){let S=y.backgroundBlurriness>0;P=t.get(P,S)}return P}function m(y){let P=!1,S=p(y);S===null?g(o,a):S&&S.isColor&&(g(S,1),P=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||P)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,P){let S=p(P);S&&S.isCubeTexture?(c===void 0&&(c=new Ee(new Ai(1,1,1),new Zi({name:"BackgroundCubeMaterial",uniforms:fr(ji.backgroundCube.uniforms),vertexShader:ji.backgroundCube.vertexShader,fragmentShader:ji.backgroundCube.fragmentShader,side:Un,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,M,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=P.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Rv.makeRotationFromEuler(P.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(rm),c.material.toneMapped=_e.getTransfer(S.colorSpace)!==Ce,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Ee(new oa(2,2),new Zi({name:"BackgroundMaterial",uniforms:fr(ji.background.uniforms),vertexShader:ji.background.vertexShader,fragmentShader:ji.background.fragmentShader,side:Ws,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,l.material.toneMapped=_e.getTransfer(S.colorSpace)!==Ce,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,P){y.getRGB(zc,$u(n)),e.buffers.color.setClear(zc.r,zc.g,zc.b,P,r)}function d(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,P=1){o.set(y),a=P,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:x,dispose:d}}function Iv(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(E,N,F,I,B){let X=!1,z=f(E,I,F,N);r!==z&&(r=z,c(r.object)),X=p(E,I,F,B),X&&m(E,I,F,B),B!==null&&t.update(B,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,S(E,N,F,I),B!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function l(){return n.createVertexArray()}function c(E){return n.bindVertexArray(E)}function u(E){return n.deleteVertexArray(E)}function f(E,N,F,I){let B=I.wireframe===!0,X=i[N.id];X===void 0&&(X={},i[N.id]=X);let z=E.isInstancedMesh===!0?E.id:0,ht=X[z];ht===void 0&&(ht={},X[z]=ht);let Y=ht[F.id];Y===void 0&&(Y={},ht[F.id]=Y);let tt=Y[B];return tt===void 0&&(tt=h(l()),Y[B]=tt),tt}function h(E){let N=[],F=[],I=[];for(let B=0;B<e;B++)N[B]=0,F[B]=0,I[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:F,attributeDivisors:I,object:E,attributes:{},index:null}}function p(E,N,F,I){let B=r.attributes,X=N.attributes,z=0,ht=F.getAttributes();for(let Y in ht)if(ht[Y].location>=0){let rt=B[Y],Q=X[Y];if(Q===void 0&&(Y==="instanceMatrix"&&E.instanceMatrix&&(Q=E.instanceMatrix),Y==="instanceColor"&&E.instanceColor&&(Q=E.instanceColor)),rt===void 0||rt.attribute!==Q||Q&&rt.data!==Q.data)return!0;z++}return r.attributesNum!==z||r.index!==I}function m(E,N,F,I){let B={},X=N.attributes,z=0,ht=F.getAttributes();for(let Y in ht)if(ht[Y].location>=0){let rt=X[Y];rt===void 0&&(Y==="instanceMatrix"&&E.instanceMatrix&&(rt=E.instanceMatrix),Y==="instanceColor"&&E.instanceColor&&(rt=E.instanceColor));let Q={};Q.attribute=rt,rt&&rt.data&&(Q.data=rt.data),B[Y]=Q,z++}r.attributes=B,r.attributesNum=z,r.index=I}function x(){let E=r.newAttributes;for(let N=0,F=E.length;N<F;N++)E[N]=0}function g(E){d(E,0)}function d(E,N){let F=r.newAttributes,I=r.enabledAttributes,B=r.attributeDivisors;F[E]=1,I[E]===0&&(n.enableVertexAttribArray(E),I[E]=1),B[E]!==N&&(n.vertexAttribDivisor(E,N),B[E]=N)}function y(){let E=r.newAttributes,N=r.enabledAttributes;for(let F=0,I=N.length;F<I;F++)N[F]!==E[F]&&(n.disableVertexAttribArray(F),N[F]=0)}function P(E,N,F,I,B,X,z){z===!0?n.vertexAttribIPointer(E,N,F,B,X):n.vertexAttribPointer(E,N,F,I,B,X)}function S(E,N,F,I){x();let B=I.attributes,X=F.getAttributes(),z=N.defaultAttributeValues;for(let ht in X){let Y=X[ht];if(Y.location>=0){let tt=B[ht];if(tt===void 0&&(ht==="instanceMatrix"&&E.instanceMatrix&&(tt=E.instanceMatrix),ht==="instanceColor"&&E.instanceColor&&(tt=E.instanceColor)),tt!==void 0){let rt=tt.normalized,Q=tt.itemSize,st=t.get(tt);if(st===void 0)continue;let $=st.buffer,ft=st.type,it=st.bytesPerElement,gt=ft===n.INT||ft===n.UNSIGNED_INT||tt.gpuType===ec;if(tt.isInterleavedBufferAttribute){let mt=tt.data,W=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,nt=tt.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let lt=0;lt<Y.locationSize;lt++)d(Y.location+lt,mt.meshPerAttribute);E.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let lt=0;lt<Y.locationSize;lt++)g(Y.location+lt);n.bindBuffer(n.ARRAY_BUFFER,$);for(let lt=0;lt<Y.locationSize;lt++)P(Y.location+lt,Q/Y.locationSize,ft,rt,W*it,(nt+Q/Y.locationSize*lt)*it,gt)}else{if(tt.isInstancedBufferAttribute){for(let mt=0;mt<Y.locationSize;mt++)d(Y.location+mt,tt.meshPerAttribute);E.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let mt=0;mt<Y.locationSize;mt++)g(Y.location+mt);n.bindBuffer(n.ARRAY_BUFFER,$);for(let mt=0;mt<Y.locationSize;mt++)P(Y.location+mt,Q/Y.locationSize,ft,rt,Q*it,Q/Y.locationSize*mt*it,gt)}}else if(z!==void 0){let rt=z[ht];if(rt!==void 0)switch(rt.length){case 2:n.vertexAttrib2fv(Y.location,rt);break;case 3:n.vertexAttrib3fv(Y.location,rt);break;case 4:n.vertexAttrib4fv(Y.location,rt);break;default:n.vertexAttrib1fv(Y.location,rt)}}}}y()}function R(){D();for(let E in i){let N=i[E];for(let F in N){let I=N[F];for(let B in I){let X=I[B];for(let z in X)u(X[z].object),delete X[z];delete I[B]}}delete i[E]}}function M(E){if(i[E.id]===void 0)return;let N=i[E.id];for(let F in N){let I=N[F];for(let B in I){let X=I[B];for(let z in X)u(X[z].object),delete X[z];delete I[B]}}delete i[E.id]}function _(E){for(let N in i){let F=i[N];for(let I in F){let B=F[I];if(B[E.id]===void 0)continue;let X=B[E.id];for(let z in X)u(X[z].object),delete X[z];delete B[E.id]}}}function b(E){for(let N in i){let F=i[N],I=E.isInstancedMesh===!0?E.id:0,B=F[I];if(B!==void 0){for(let X in B){let z=B[X];for(let ht in z)u(z[ht].object),delete z[ht];delete B[X]}delete F[I],Object.keys(F).length===0&&delete i[N]}}}function D(){A(),o=!0,r!==s&&(r=s,c(r.object))}function A(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:A,dispose:R,releaseStatesOfGeometry:M,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:g,disableUnusedAttributes:y}}function Lv(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let p=0;p<u;p++)h+=c[p];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Dv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Ii&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Pi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==jn&&_!==Ri&&!b&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Jt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),P=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:g,maxAttributes:d,maxVertexUniforms:y,maxVaryings:P,maxFragmentUniforms:S,maxSamples:R,samples:M}}function Nv(n){let t=this,e=null,i=0,s=!1,r=!1,o=new In,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let p=f.length!==0||h||i!==0||s;return s=h,i=f.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){e=u(f,h,0)},this.setState=function(f,h,p){let m=f.clippingPlanes,x=f.clipIntersection,g=f.clipShadows,d=n.get(f);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let y=r?0:i,P=y*4,S=d.clippingState||null;l.value=S,S=u(m,h,P,p);for(let R=0;R!==P;++R)S[R]=e[R];d.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(f,h,p,m){let x=f!==null?f.length:0,g=null;if(x!==0){if(g=l.value,m!==!0||g===null){let d=p+x*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<d)&&(g=new Float32Array(d));for(let P=0,S=p;P!==x;++P,S+=4)o.copy(f[P]).applyMatrix4(y,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var Ea=class extends oi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ea(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ai(5,5,5),r=new Zi({name:"CubemapFromEquirect",uniforms:fr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Un,blending:lr});r.uniforms.tEquirect.value=e;let o=new Ee(s,r),a=e.minFilter;return e.minFilter===_s&&(e.minFilter=Dn),new oo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Op=256,Uv=3,Fv=20,om=256,am=16,Ov=3,Bv=new G,zv=new re,Vc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new oo(1,10,null),this._boxMesh=new Ee(new Ai(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Bv}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(zv));let g=new oo(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=p,l.autoClearStencil=m,t.background=x,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=kp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=zp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Op,Wu(t))}_fromTexture(t,e){t.mapping===hr||t.mapping===ho?this._setSize(t.image.length===0?Op:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Bp(t,!1,!1),i=Math.log2(t)-Uv;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Bp(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===hr||t.mapping===ho?(this._cubemapMaterial===null&&(this._cubemapMaterial=kp()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=zp()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=kv(),this._integrationMaterial=Vv());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/am);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Ov)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(om*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Gv());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Bp(n,t,e){return new Ea(n,{minFilter:_s,generateMipmaps:t,type:Pi,colorSpace:Xo,depthBuffer:e})}function Ta(n,t,e){return new Zi({name:n,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:Un,blending:lr,depthTest:!1,depthWrite:!1})}function kv(){return Ta("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${om}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Vv(){return Ta("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:am}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Gv(){return Ta("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Fv}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function zp(){return Ta("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function kp(){return Ta("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Hv(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,p=!1){return h==null?null:p?o(h):r(h)}function r(h){if(h&&h.isTexture){let p=h.mapping;if(p===jl||p===Ql)if(t.has(h)){let m=t.get(h).texture;return a(m,h.mapping)}else{let m=h.image;if(m&&m.height>0){let x=new Ea(m.height);return x.fromEquirectangularTexture(n,h),t.set(h,x),h.addEventListener("dispose",c),a(x.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let p=h.mapping,m=p===jl||p===Ql,x=p===hr||p===ho;if(m||x){let g=e.get(h),d=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==d)return i===null&&(i=new Vc(n)),g=m?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return m&&y&&y.height>0||x&&y&&l(y)?(i===null&&(i=new Vc(n)),g=m?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,p){return p===jl?h.mapping=hr:p===Ql&&(h.mapping=ho),h}function l(h){let p=0,m=6;for(let x=0;x<m;x++)h[x]!==void 0&&p++;return p===m}function c(h){let p=h.target;p.removeEventListener("dispose",c);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function u(h){let p=h.target;p.removeEventListener("dispose",u);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function f(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function Wv(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Go("WebGLRenderer: "+i+" extension not supported."),s}}}function Xv(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let x=r.get(m);x&&(t.remove(x),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function u(m){let x=m.attributes;for(let g in x)t.update(x[g],n.ARRAY_BUFFER)}function f(m){let x=m.index,g=m.attributes.position,d=0;if(g===void 0)return;let y=x!==null?x.array.length:g.array.length/3-1,P=g.count>=65535?jo:Ko,S=new P(Math.ceil(y/3)*6,1),R=S.array;if(x!==null){let _=x.array;d=x.version;for(let b=0,D=0;b<y;b+=3){let A=_[b+0],E=_[b+1],N=_[b+2];R[D++]=A,R[D++]=E,R[D++]=E,R[D++]=N,R[D++]=N,R[D++]=A}}else{d=g.version;for(let _=0,b=0;_<y;_+=3){let D=_+0,A=_+1,E=_+2;R[b++]=D,R[b++]=A,R[b++]=A,R[b++]=E,R[b++]=E,R[b++]=D}}S.version=d;let M=r.get(m);M&&t.remove(M),r.set(m,S)}function h(m){let x=r.get(m);if(x){let g=m.index;g!==null&&x.version<g.version&&f(m)}else f(m);return r.get(m)}function p(){for(let m in s){let x=s[m].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:h,dispose:p}}function qv(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),e.update(h,i,1)}function c(f,h,p){p!==0&&(n.drawElementsInstanced(i,h,r,f*o,p),e.update(h,i,p))}function u(f,h,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,p);let x=0;for(let g=0;g<p;g++)x+=h[g];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Yv(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Qt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function $v(n,t,e){let i=new WeakMap,s=new $e;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let D=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",D)};h!==void 0&&h.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],P=0;p===!0&&(P=1),m===!0&&(P=2),x===!0&&(P=3);let S=a.attributes.position.count*P,R=1;S>t.maxTextureSize&&(R=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let M=new Float32Array(S*R*4*f),_=new Zo(M,S,R,f);_.type=Ri,_.needsUpdate=!0;let b=P*4;for(let A=0;A<f;A++){let E=g[A],N=d[A],F=y[A],I=S*R*4*A;for(let B=0;B<E.count;B++){let X=B*b;p===!0&&(s.fromBufferAttribute(E,B),M[I+X+0]=s.x,M[I+X+1]=s.y,M[I+X+2]=s.z,M[I+X+3]=0),m===!0&&(s.fromBufferAttribute(N,B),M[I+X+4]=s.x,M[I+X+5]=s.y,M[I+X+6]=s.z,M[I+X+7]=0),x===!0&&(s.fromBufferAttribute(F,B),M[I+X+8]=s.x,M[I+X+9]=s.y,M[I+X+10]=s.z,M[I+X+11]=F.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new Yt(S,R)},i.set(a,h),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function Zv(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=t.get(c,f);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var Jv={[bu]:"LINEAR_TONE_MAPPING",[wu]:"REINHARD_TONE_MAPPING",[Eu]:"CINEON_TONE_MAPPING",[Tu]:"ACES_FILMIC_TONE_MAPPING",[Cu]:"AGX_TONE_MAPPING",[Ru]:"NEUTRAL_TONE_MAPPING",[Au]:"CUSTOM_TONE_MAPPING"};function Kv(n,t,e,i,s,r){let o=new oi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new pn;u.setAttribute("position",new Fe([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Fe([0,2,0,0,2,0],2));let f=new Fl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Ee(u,f),p=new ha(-1,1,1,-1,0,1),m=null,x=null,g=!1,d,y=null,P=[],S=!1;this.setSize=function(R,M){o.setSize(R,M),a!==null&&a.setSize(R,M),l!==null&&l.setSize(R,M);for(let _=0;_<P.length;_++){let b=P[_];b.setSize&&b.setSize(R,M)}},this.setEffects=function(R){P=R,S=P.length>0&&P[0].isRenderPass===!0;let M=o.width,_=o.height;P.length>0&&a===null&&(a=new oi(M,_,{type:Pi,depthBuffer:!1,stencilBuffer:!1}),l=new oi(M,_,{type:Pi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&P.some(D=>D.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new ms(M,_),r===!0&&(c.format=xs,c.type=ur)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let D=0;D<P.length;D++){let A=P[D];A.setSize&&A.setSize(M,_),b&&A.needsDepthTexture===!0&&A.setDepthTexture&&A.setDepthTexture(c)}},this.begin=function(R,M){if(g||R.toneMapping===Ji&&P.length===0)return!1;if(y=M,M!==null){let _=M.width,b=M.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return S===!1&&R.setRenderTarget(o),d=R.toneMapping,R.toneMapping=Ji,!0},this.hasRenderPass=function(){return S},this.end=function(R,M){R.toneMapping=d,g=!0;let _=o,b=a;for(let D=0;D<P.length;D++){let A=P[D];A.enabled!==!1&&(A.render(R,b,_,M),A.needsSwap!==!1&&(_=b,b=b===a?l:a))}if(m!==R.outputColorSpace||x!==R.toneMapping){m=R.outputColorSpace,x=R.toneMapping,f.defines={},_e.getTransfer(m)===Ce&&(f.defines.SRGB_TRANSFER="");let D=Jv[x];D&&(f.defines[D]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(y),R.render(h,p),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var lm=new Zn,cm=new ms(1,1),hm=new ia(1),um=new Zo,fm=new Il,dm=new ea,Vp=[],Gp=[],Hp=new Float32Array(16),Wp=new Float32Array(9),Xp=new Float32Array(4);function po(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Vp[s];if(r===void 0&&(r=new Float32Array(s),Vp[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function yn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function vn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Hc(n,t){let e=Gp[t];e===void 0&&(e=new Int32Array(t),Gp[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function jv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Qv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2fv(this.addr,t),vn(e,t)}}function tS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(yn(e,t))return;n.uniform3fv(this.addr,t),vn(e,t)}}function eS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4fv(this.addr,t),vn(e,t)}}function nS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;Xp.set(i),n.uniformMatrix2fv(this.addr,!1,Xp),vn(e,i)}}function iS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;Wp.set(i),n.uniformMatrix3fv(this.addr,!1,Wp),vn(e,i)}}function sS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;Hp.set(i),n.uniformMatrix4fv(this.addr,!1,Hp),vn(e,i)}}function rS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function oS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2iv(this.addr,t),vn(e,t)}}function aS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3iv(this.addr,t),vn(e,t)}}function lS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4iv(this.addr,t),vn(e,t)}}function cS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function hS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2uiv(this.addr,t),vn(e,t)}}function uS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3uiv(this.addr,t),vn(e,t)}}function fS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4uiv(this.addr,t),vn(e,t)}}function Wc(n){return n.version===0&&(n.compareFunction=ku,n.needsUpdate=!0),n}function dS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Wc(cm):r=lm,e.setTexture2D(t||r,s)}function pS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||fm,s)}function mS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Wc(hm):r=dm,e.setTextureCube(t||r,s)}function gS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||um,s)}function _S(n){switch(n){case 5126:return jv;case 35664:return Qv;case 35665:return tS;case 35666:return eS;case 35674:return nS;case 35675:return iS;case 35676:return sS;case 5124:case 35670:return rS;case 35667:case 35671:return oS;case 35668:case 35672:return aS;case 35669:case 35673:return lS;case 5125:return cS;case 36294:return hS;case 36295:return uS;case 36296:return fS;case 35678:case 36198:case 36298:case 36306:case 35682:return dS;case 35679:case 36299:case 36307:return pS;case 35680:case 36300:case 36308:case 36293:return mS;case 36289:case 36303:case 36311:case 36292:return gS}}function xS(n,t){n.uniform1fv(this.addr,t)}function yS(n,t){let e=po(t,this.size,2);n.uniform2fv(this.addr,e)}function vS(n,t){let e=po(t,this.size,3);n.uniform3fv(this.addr,e)}function SS(n,t){let e=po(t,this.size,4);n.uniform4fv(this.addr,e)}function MS(n,t){let e=po(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function bS(n,t){let e=po(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function wS(n,t){let e=po(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function ES(n,t){n.uniform1iv(this.addr,t)}function TS(n,t){n.uniform2iv(this.addr,t)}function AS(n,t){n.uniform3iv(this.addr,t)}function CS(n,t){n.uniform4iv(this.addr,t)}function RS(n,t){n.uniform1uiv(this.addr,t)}function PS(n,t){n.uniform2uiv(this.addr,t)}function IS(n,t){n.uniform3uiv(this.addr,t)}function LS(n,t){n.uniform4uiv(this.addr,t)}function DS(n,t,e){let i=this.cache,s=t.length,r=Hc(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Wc(cm):o=lm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function NS(n,t,e){let i=this.cache,s=t.length,r=Hc(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||fm,r[o])}function US(n,t,e){let i=this.cache,s=t.length,r=Hc(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Wc(hm):o=dm;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function FS(n,t,e){let i=this.cache,s=t.length,r=Hc(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||um,r[o])}function OS(n){switch(n){case 5126:return xS;case 35664:return yS;case 35665:return vS;case 35666:return SS;case 35674:return MS;case 35675:return bS;case 35676:return wS;case 5124:case 35670:return ES;case 35667:case 35671:return TS;case 35668:case 35672:return AS;case 35669:case 35673:return CS;case 5125:return RS;case 36294:return PS;case 36295:return IS;case 36296:return LS;case 35678:case 36198:case 36298:case 36306:case 35682:return DS;case 35679:case 36299:case 36307:return NS;case 35680:case 36300:case 36308:case 36293:return US;case 36289:case 36303:case 36311:case 36292:return FS}}var tf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=_S(e.type)}},ef=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=OS(e.type)}},nf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},ju=/(\w+)(\])?(\[|\.)?/g;function qp(n,t){n.seq.push(t),n.map[t.id]=t}function BS(n,t,e){let i=n.name,s=i.length;for(ju.lastIndex=0;;){let r=ju.exec(i),o=ju.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){qp(e,c===void 0?new tf(a,n,t):new ef(a,n,t));break}else{let f=e.map[a];f===void 0&&(f=new nf(a),qp(e,f)),e=f}}}var fo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);BS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Yp(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var zS=37297,kS=0;function VS(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var $p=new ie;function GS(n){_e._getMatrix($p,_e.workingColorSpace,n);let t=`mat3( ${$p.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(n)){case qo:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return Jt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Zp(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+VS(n.getShaderSource(t),a)}else return r}function HS(n,t){let e=GS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var WS={[bu]:"Linear",[wu]:"Reinhard",[Eu]:"Cineon",[Tu]:"ACESFilmic",[Cu]:"AgX",[Ru]:"Neutral",[Au]:"Custom"};function XS(n,t){let e=WS[t];return e===void 0?(Jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var kc=new G;function qS(){_e.getLuminanceCoefficients(kc);let n=kc.x.toFixed(4),t=kc.y.toFixed(4),e=kc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function YS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(wa).join(`
`)}function $S(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function ZS(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function wa(n){return n!==""}function Jp(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Kp(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var JS=/^[ \t]*#include +<([\w\d./]+)>/gm;function sf(n){return n.replace(JS,KS)}function KS(n,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return sf(e)}var jS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function jp(n){return n.replace(jS,QS)}function QS(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Qp(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var tM={[ma]:"SHADOWMAP_TYPE_PCF",[lo]:"SHADOWMAP_TYPE_VSM"};function eM(n){return tM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var nM={[ho]:"ENVMAP_MODE_REFRACTION"};function iM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":nM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var sM={[Kl]:"ENVMAP_BLENDING_MULTIPLY",[_p]:"ENVMAP_BLENDING_MIX",[xp]:"ENVMAP_BLENDING_ADD"};function rM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":sM[n.combine]||"ENVMAP_BLENDING_NONE"}function oM(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=eM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=iM(e),f=rM(e),h=YS(e),p=$S(r),m=s.createProgram(),x,g,d=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(wa).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(wa).join(`
`),g.length>0&&(g+=`
`)):(x=[Qp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(wa).join(`
`),g=[Qp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ji?"#define TONE_MAPPING":"",e.toneMapping!==Ji?ce.tonemapping_pars_fragment:"",e.toneMapping!==Ji?XS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,HS("linearToOutputTexel",e.outputColorSpace),qS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(wa).join(`
`)),o=sf(o),o=Jp(o,e),o=Kp(o,e),a=sf(a),a=Jp(a,e),a=Kp(a,e),o=jp(o),a=jp(a),e.isRawShaderMaterial!==!0&&(d=`#version 300 es
`,x=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===Gu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Gu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=d+x+o,P=d+g+a,S=Yp(s,s.VERTEX_SHADER,y),R=Yp(s,s.FRAGMENT_SHADER,P);s.attachShader(m,S),s.attachShader(m,R),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function M(A){if(n.debug.checkShaderErrors){let E=s.getProgramInfoLog(m)||"",N=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(R)||"",I=E.trim(),B=N.trim(),X=F.trim(),z=!0,ht=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,S,R);else{let Y=Zp(s,S,"vertex"),tt=Zp(s,R,"fragment");Qt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+I+`
`+Y+`
`+tt)}else I!==""?Jt("WebGLProgram: Program Info Log:",I):(B===""||X==="")&&(ht=!1);ht&&(A.diagnostics={runnable:z,programLog:I,vertexShader:{log:B,prefix:x},fragmentShader:{log:X,prefix:g}})}s.deleteShader(S),s.deleteShader(R),_=new fo(s,m),b=ZS(s,m)}let _;this.getUniforms=function(){return _===void 0&&M(this),_};let b;this.getAttributes=function(){return b===void 0&&M(this),b};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(m,zS)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=kS++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=R,this}var aM=0,rf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new of(t),e.set(t,i)),i}},of=class{constructor(t){this.id=aM++,this.code=t,this.usedTimes=0}};function lM(n){return n===Xs||n===Sa||n===Ma}function cM(n,t,e,i,s,r){let o=new eo,a=new rf,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,b,D,A,E,N){let F=A.fog,I=E.geometry,B=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?A.environment:null,X=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=t.get(_.envMap||B,X),ht=h[_.type],Y=i.precision;_.precision!==null&&(Y=i.getMaxPrecision(_.precision),Y!==_.precision&&Jt("WebGLProgram.getParameters:",_.precision,"not supported, using",Y,"instead."));let tt=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,rt=tt!==void 0?tt.length:0,Q=0;I.morphAttributes.position!==void 0&&(Q=1),I.morphAttributes.normal!==void 0&&(Q=2),I.morphAttributes.color!==void 0&&(Q=3);let st,$,ft,it;if(ht){let Pt=ji[ht];st=Pt.vertexShader,$=Pt.fragmentShader}else{st=_.vertexShader,$=_.fragmentShader;let Pt=a.getVertexShaderStage(_),ae=a.getFragmentShaderStage(_);a.update(_,Pt,ae),ft=Pt.id,it=ae.id}let gt=n.getRenderTarget(),mt=n.state.buffers.depth.getReversed(),W=E.isInstancedMesh===!0,nt=E.isBatchedMesh===!0,lt=!!_.map,Dt=!!_.matcap,Ot=!!z,Xt=Ot&&z.isPMREMTexture===!0,he=!!_.aoMap,ye=!!_.lightMap,ze=!!_.bumpMap&&_.wireframe===!1,ve=!!_.normalMap,Ke=!!_.displacementMap,me=!!_.emissiveMap,sn=!!_.metalnessMap,Ne=!!_.roughnessMap,je=_.anisotropy>0,V=_.clearcoat>0,It=_.diffuseRoughness>0,Kt=_.dispersion>0,oe=_.retroreflectivity>0,Tt=_.iridescence>0,Ue=_.sheen>0,Wt=_.transmission>0,Zt=je&&!!_.anisotropyMap,L=V&&!!_.clearcoatMap,w=V&&!!_.clearcoatNormalMap,Z=V&&!!_.clearcoatRoughnessMap,xt=It&&!!_.diffuseRoughnessMap,dt=Tt&&!!_.iridescenceMap,Mt=Tt&&!!_.iridescenceThicknessMap,bt=Ue&&!!_.sheenColorMap,ot=Ue&&!!_.sheenRoughnessMap,ct=!!_.specularMap,vt=!!_.specularColorMap,k=!!_.specularIntensityMap,ut=Wt&&!!_.transmissionMap,at=Wt&&!!_.thicknessMap,At=!!_.gradientMap,St=!!_.alphaMap,Et=_.alphaTest>0,qt=!!_.alphaHash,te=!!_.extensions,_t=Ji;_.toneMapped&&(gt===null||gt.isXRRenderTarget===!0)&&(_t=n.toneMapping);let Vt=Xt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,ee={shaderID:ht,shaderType:_.type,shaderName:_.name,vertexShader:st,fragmentShader:$,defines:_.defines,customVertexShaderID:ft,customFragmentShaderID:it,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Y,batching:nt,batchingColor:nt&&E._colorsTexture!==null,instancing:W,instancingColor:W&&E.instanceColor!==null,instancingMorph:W&&E.morphTexture!==null,outputColorSpace:gt===null?n.outputColorSpace:gt.isXRRenderTarget===!0?gt.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:lt,matcap:Dt,envMap:Ot,envMapMode:Ot&&z.mapping,envMapPMREM:Xt,envMapMaxLod:Xt?Vt.length-1:null,envMapSize:Xt?Vt[0].width:null,aoMap:he,lightMap:ye,bumpMap:ze,normalMap:ve,displacementMap:Ke,emissiveMap:me,normalMapObjectSpace:ve&&_.normalMapType===Sp,normalMapTangentSpace:ve&&_.normalMapType===Oc,packedNormalMap:ve&&_.normalMapType===Oc&&lM(_.normalMap.format),metalnessMap:sn,roughnessMap:Ne,anisotropy:je,anisotropyMap:Zt,clearcoat:V,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:Z,diffuseRoughness:It,diffuseRoughnessMap:xt,dispersion:Kt,retroreflection:oe,iridescence:Tt,iridescenceMap:dt,iridescenceThicknessMap:Mt,sheen:Ue,sheenColorMap:bt,sheenRoughnessMap:ot,specularMap:ct,specularColorMap:vt,specularIntensityMap:k,transmission:Wt,transmissionMap:ut,thicknessMap:at,gradientMap:At,opaque:_.transparent===!1&&_.blending===co&&_.alphaToCoverage===!1,alphaMap:St,alphaTest:Et,alphaHash:qt,combine:_.combine,mapUv:lt&&p(_.map.channel),aoMapUv:he&&p(_.aoMap.channel),lightMapUv:ye&&p(_.lightMap.channel),bumpMapUv:ze&&p(_.bumpMap.channel),normalMapUv:ve&&p(_.normalMap.channel),displacementMapUv:Ke&&p(_.displacementMap.channel),emissiveMapUv:me&&p(_.emissiveMap.channel),metalnessMapUv:sn&&p(_.metalnessMap.channel),roughnessMapUv:Ne&&p(_.roughnessMap.channel),anisotropyMapUv:Zt&&p(_.anisotropyMap.channel),clearcoatMapUv:L&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:xt&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:dt&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:Mt&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:bt&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:ot&&p(_.sheenRoughnessMap.channel),specularMapUv:ct&&p(_.specularMap.channel),specularColorMapUv:vt&&p(_.specularColorMap.channel),specularIntensityMapUv:k&&p(_.specularIntensityMap.channel),transmissionMapUv:ut&&p(_.transmissionMap.channel),thicknessMapUv:at&&p(_.thicknessMap.channel),alphaMapUv:St&&p(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(ve||je),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:E.isPoints===!0&&!!I.attributes.uv&&(lt||St),fog:!!F,useFog:_.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&ve===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:mt,skinning:E.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:Q,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:N.filter(Pt=>Pt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:_t,decodeVideoTexture:lt&&_.map.isVideoTexture===!0&&_e.getTransfer(_.map.colorSpace)===Ce,decodeVideoTextureEmissive:me&&_.emissiveMap.isVideoTexture===!0&&_e.getTransfer(_.emissiveMap.colorSpace)===Ce,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===gi,flipSided:_.side===Un,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:te&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&_.extensions.multiDraw===!0||nt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ee.vertexUv1s=l.has(1),ee.vertexUv2s=l.has(2),ee.vertexUv3s=l.has(3),l.clear(),ee}function x(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let D in _.defines)b.push(D),b.push(_.defines[D]);return _.isRawShaderMaterial===!1&&(g(b,_),d(b,_),b.push(n.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function g(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function d(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let b=h[_.type],D;if(b){let A=ji[b];D=Np.clone(A.uniforms)}else D=_.uniforms;return D}function P(_,b){let D=u.get(b);return D!==void 0?++D.usedTimes:(D=new oM(n,b,_,s),c.push(D),u.set(b,D)),D}function S(_){if(--_.usedTimes===0){let b=c.indexOf(_);c[b]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function M(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:y,acquireProgram:P,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:M}}function hM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function uM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function tm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function em(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let p=0;return h.isInstancedMesh&&(p+=2),h.isSkinnedMesh&&(p+=1),p}function a(h,p,m,x,g,d){let y=n[t];return y===void 0?(y={id:h.id,object:h,geometry:p,material:m,materialVariant:o(h),groupOrder:x,renderOrder:h.renderOrder,z:g,group:d},n[t]=y):(y.id=h.id,y.object=h,y.geometry=p,y.material=m,y.materialVariant=o(h),y.groupOrder=x,y.renderOrder=h.renderOrder,y.z=g,y.group=d),t++,y}function l(h,p,m,x,g,d,y){y.reversedDepth===!0&&(g=-g);let P=a(h,p,m,x,g,d);m.transmission>0?i.push(P):m.transparent===!0?s.push(P):e.push(P)}function c(h,p,m,x,g,d){let y=a(h,p,m,x,g,d);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):e.unshift(y)}function u(h,p){e.length>1&&e.sort(h||uM),i.length>1&&i.sort(p||tm),s.length>1&&s.sort(p||tm)}function f(){for(let h=t,p=n.length;h<p;h++){let m=n[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function fM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new em,n.set(i,[o])):s>=r.length?(o=new em,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function dM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new re};break;case"SpotLight":e={position:new G,direction:new G,color:new re,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new re,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new re,groundColor:new re};break;case"RectAreaLight":e={color:new re,position:new G,halfWidth:new G,halfHeight:new G};break}return n[t.id]=e,e}}}function pM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var mM=0;function gM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function _M(n){let t=new dM,e=pM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new we,o=new we;function a(c){let u=0,f=0,h=0;for(let N=0;N<9;N++)i.probe[N].set(0,0,0);let p=0,m=0,x=0,g=0,d=0,y=0,P=0,S=0,R=0,M=0,_=0,b=0,D=0,A=0;c.sort(gM);for(let N=0,F=c.length;N<F;N++){let I=c[N],B=I.color,X=I.intensity,z=I.distance,ht=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Xs?ht=I.shadow.map.texture:ht=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=B.r*X,f+=B.g*X,h+=B.b*X;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(I.sh.coefficients[Y],X);A++}else if(I.isSunLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let tt=I.shadow,rt=e.get(I);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),i.sunShadow[m]=rt,i.sunShadowMap[m]=ht;let Q=tt.getViewportCount();for(let st=0;st<Q;st++)i.sunShadowMatrix[x+st]=tt.getMatrix(st),i.sunShadowCascade[x+st]=tt._cascadeData[st];x+=Q,m++}i.sun[p]=Y,p++}else if(I.isDirectionalLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let tt=I.shadow,rt=e.get(I);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,i.directionalShadow[g]=rt,i.directionalShadowMap[g]=ht,i.directionalShadowMatrix[g]=I.shadow.matrix,R++}i.directional[g]=Y,g++}else if(I.isSpotLight){let Y=t.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(B).multiplyScalar(X),Y.distance=z,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,i.spot[y]=Y;let tt=I.shadow;if(I.map&&(i.spotLightMap[b]=I.map,b++,tt.updateMatrices(I),I.castShadow&&D++),i.spotLightMatrix[y]=tt.matrix,I.castShadow){let rt=e.get(I);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,i.spotShadow[y]=rt,i.spotShadowMap[y]=ht,_++}y++}else if(I.isRectAreaLight){let Y=t.get(I);Y.color.copy(B).multiplyScalar(X),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),i.rectArea[P]=Y,P++}else if(I.isPointLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let tt=I.shadow,rt=e.get(I);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,rt.shadowCameraNear=tt.camera.near,rt.shadowCameraFar=tt.camera.far,i.pointShadow[d]=rt,i.pointShadowMap[d]=ht,i.pointShadowMatrix[d]=I.shadow.matrix,M++}i.point[d]=Y,d++}else if(I.isHemisphereLight){let Y=t.get(I);Y.skyColor.copy(I.color).multiplyScalar(X),Y.groundColor.copy(I.groundColor).multiplyScalar(X),i.hemi[S]=Y,S++}}P>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ut.LTC_FLOAT_1,i.rectAreaLTC2=Ut.LTC_FLOAT_2):(i.rectAreaLTC1=Ut.LTC_HALF_1,i.rectAreaLTC2=Ut.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let E=i.hash;(E.sunLength!==p||E.directionalLength!==g||E.pointLength!==d||E.spotLength!==y||E.rectAreaLength!==P||E.hemiLength!==S||E.numSunShadows!==m||E.numDirectionalShadows!==R||E.numPointShadows!==M||E.numSpotShadows!==_||E.numSpotMaps!==b||E.numLightProbes!==A)&&(i.sun.length=p,i.directional.length=g,i.spot.length=y,i.rectArea.length=P,i.point.length=d,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+b-D,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=A,E.sunLength=p,E.directionalLength=g,E.pointLength=d,E.spotLength=y,E.rectAreaLength=P,E.hemiLength=S,E.numSunShadows=m,E.numDirectionalShadows=R,E.numPointShadows=M,E.numSpotShadows=_,E.numSpotMaps=b,E.numLightProbes=A,i.version=mM++)}function l(c,u){let f=0,h=0,p=0,m=0,x=0,g=0,d=u.matrixWorldInverse;for(let y=0,P=c.length;y<P;y++){let S=c[y];if(S.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(d),f++}else if(S.isDirectionalLight){let R=i.directional[h];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(d),h++}else if(S.isSpotLight){let R=i.spot[m];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(d),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(d),m++}else if(S.isRectAreaLight){let R=i.rectArea[x];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(d),o.identity(),r.copy(S.matrixWorld),r.premultiply(d),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let R=i.point[p];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(d),p++}else if(S.isHemisphereLight){let R=i.hemi[g];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(d),g++}}}return{setup:a,setupView:l,state:i}}function nm(n){let t=new _M(n),e=[],i=[],s=[];function r(f){u.camera=f,e.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):e.push(f)}function a(f){i.push(f)}function l(){t.setup(e),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){t.setupView(e,f)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function xM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new nm(n),t.set(s,[a])):r>=o.length?(a=new nm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var yM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,vM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,SM=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],MM=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],im=new we,ba=new G,Qu=new G;function bM(n,t,e){let i=new Bs,s=new Yt,r=new Yt,o=new $e,a=new Ol,l=new Bl,c={},u=e.maxTextureSize,f={[Ws]:Un,[Un]:Ws,[gi]:gi},h=new Zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:yM,fragmentShader:vM}),p=h.clone();p.defines.HORIZONTAL_PASS=1;let m=new pn;m.setAttribute("position",new Ln(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ee(m,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ma;let d=this.type;this.render=function(M,_,b){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===jd&&(Jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ma);let D=n.getRenderTarget(),A=n.getActiveCubeFace(),E=n.getActiveMipmapLevel(),N=n.state;N.setBlending(lr),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let F=d!==this.type;F&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(B=>B.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,B=M.length;I<B;I++){let X=M[I],z=X.shadow;if(z===void 0){Jt("WebGLShadowMap:",X,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ht=z.getFrameExtents();s.multiply(ht),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,z.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Y,z.map===null||F===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===lo){if(X.isPointLight){Jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new oi(s.x,s.y,{format:Xs,type:Pi,minFilter:Dn,magFilter:Dn,generateMipmaps:!1}),z.map.texture.name=X.name+".shadowMap",z.map.depthTexture=new ms(s.x,s.y,Ri),z.map.depthTexture.name=X.name+".shadowMapDepth",z.map.depthTexture.format=us,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Rn,z.map.depthTexture.magFilter=Rn}else X.isPointLight?(z.map=new Ea(s.x),z.map.depthTexture=new ia(s.x,Ci)):(z.map=new oi(s.x,s.y),z.map.depthTexture=new ms(s.x,s.y,Ci)),z.map.depthTexture.name=X.name+".shadowMap",z.map.depthTexture.format=us,this.type===ma?(z.map.depthTexture.compareFunction=Y?zu:Bu,z.map.depthTexture.minFilter=Dn,z.map.depthTexture.magFilter=Dn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Rn,z.map.depthTexture.magFilter=Rn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let tt=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();X.isPointLight!==!0&&z.updateMatrices(X,b);let rt=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:b.layers;for(let Q=0;Q<tt;Q++){let st=z.getCamera(Q);if(X.isPointLight){let $=z.camera,ft=z.matrix,it=X.distance||$.far;it!==$.far&&($.far=it,$.updateProjectionMatrix()),ba.setFromMatrixPosition(X.matrixWorld),$.position.copy(ba),Qu.copy($.position),Qu.add(SM[Q]),$.up.copy(MM[Q]),$.lookAt(Qu),$.updateMatrixWorld(),ft.makeTranslation(-ba.x,-ba.y,-ba.z),im.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),z._frustum.setFromProjectionMatrix(im,$.coordinateSystem,$.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,Q),n.clear();else{Q===0&&(n.setRenderTarget(z.map),n.clear());let $=z.getViewport(Q);o.set(r.x*$.x,r.y*$.y,r.x*$.z,r.y*$.w),N.viewport(o)}i=z.getFrustum(Q),S(_,b,st,X,rt,this.type)}z.isPointLightShadow!==!0&&this.type===lo&&y(z,b),z.needsUpdate=!1}d=this.type,g.needsUpdate=!1,n.setRenderTarget(D,A,E)};function y(M,_){let b=t.update(x);h.defines.VSM_SAMPLES!==M.blurSamples&&(h.defines.VSM_SAMPLES=M.blurSamples,p.defines.VSM_SAMPLES=M.blurSamples,h.needsUpdate=!0,p.needsUpdate=!0),M.mapPass===null?M.mapPass=new oi(s.x,s.y,{format:Xs,type:Pi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),h.uniforms.shadow_pass.value=M.map.depthTexture,h.uniforms.resolution.value.set(M.map.width,M.map.height),h.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(_,null,b,h,x,null),p.uniforms.shadow_pass.value=M.mapPass.texture,p.uniforms.resolution.value.set(M.map.width,M.map.height),p.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(_,null,b,p,x,null)}function P(M,_,b,D){let A=null,E=b.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(E!==void 0)A=E;else if(A=b.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let N=A.uuid,F=_.uuid,I=c[N];I===void 0&&(I={},c[N]=I);let B=I[F];B===void 0&&(B=A.clone(),I[F]=B,_.addEventListener("dispose",R)),A=B}if(A.visible=_.visible,A.wireframe=_.wireframe,D===lo?A.side=_.shadowSide!==null?_.shadowSide:_.side:A.side=_.shadowSide!==null?_.shadowSide:f[_.side],A.alphaMap=_.alphaMap,A.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,A.map=_.map,A.clipShadows=_.clipShadows,A.clippingPlanes=_.clippingPlanes,A.clipIntersection=_.clipIntersection,A.displacementMap=_.displacementMap,A.displacementScale=_.displacementScale,A.displacementBias=_.displacementBias,A.wireframeLinewidth=_.wireframeLinewidth,A.linewidth=_.linewidth,b.isPointLight===!0&&A.isMeshDistanceMaterial===!0){let N=n.properties.get(A);N.light=b}return A}function S(M,_,b,D,A,E){if(M.visible===!1)return;if(M.layers.test(A)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&E===lo)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,M.matrixWorld);let I=t.update(M),B=M.material;if(Array.isArray(B)){let X=I.groups;for(let z=0,ht=X.length;z<ht;z++){let Y=X[z],tt=B[Y.materialIndex];if(tt&&tt.visible){let rt=P(M,tt,D,E);M.onBeforeShadow(n,M,_,b,I,rt,Y),n.renderBufferDirect(b,null,I,rt,M,Y),M.onAfterShadow(n,M,_,b,I,rt,Y)}}}else if(B.visible){let X=P(M,B,D,E);M.onBeforeShadow(n,M,_,b,I,X,null),n.renderBufferDirect(b,null,I,X,M,null),M.onAfterShadow(n,M,_,b,I,X,null)}}let F=M.children;for(let I=0,B=F.length;I<B;I++)S(F[I],_,b,D,A,E)}function R(M){M.target.removeEventListener("dispose",R);for(let b in c){let D=c[b],A=M.target.uuid;A in D&&(D[A].dispose(),delete D[A])}}}function wM(n,t){function e(){let k=!1,ut=new $e,at=null,At=new $e(0,0,0,0);return{setMask:function(St){at!==St&&!k&&(n.colorMask(St,St,St,St),at=St)},setLocked:function(St){k=St},setClear:function(St,Et,qt,te,_t){_t===!0&&(St*=te,Et*=te,qt*=te),ut.set(St,Et,qt,te),At.equals(ut)===!1&&(n.clearColor(St,Et,qt,te),At.copy(ut))},reset:function(){k=!1,at=null,At.set(-1,0,0,0)}}}function i(){let k=!1,ut=!1,at=null,At=null,St=null;return{setReversed:function(Et){if(ut!==Et){let qt=t.get("EXT_clip_control");Et?qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.ZERO_TO_ONE_EXT):qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.NEGATIVE_ONE_TO_ONE_EXT),ut=Et;let te=St;St=null,this.setClear(te)}},getReversed:function(){return ut},setTest:function(Et){Et?mt(n.DEPTH_TEST):W(n.DEPTH_TEST)},setMask:function(Et){at!==Et&&!k&&(n.depthMask(Et),at=Et)},setFunc:function(Et){if(ut&&(Et=Ip[Et]),At!==Et){switch(Et){case yl:n.depthFunc(n.NEVER);break;case vl:n.depthFunc(n.ALWAYS);break;case Sl:n.depthFunc(n.LESS);break;case Jr:n.depthFunc(n.LEQUAL);break;case Ml:n.depthFunc(n.EQUAL);break;case bl:n.depthFunc(n.GEQUAL);break;case wl:n.depthFunc(n.GREATER);break;case El:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=Et}},setLocked:function(Et){k=Et},setClear:function(Et){St!==Et&&(St=Et,ut&&(Et=1-Et),n.clearDepth(Et))},reset:function(){k=!1,at=null,At=null,St=null,ut=!1}}}function s(){let k=!1,ut=null,at=null,At=null,St=null,Et=null,qt=null,te=null,_t=null;return{setTest:function(Vt){k||(Vt?mt(n.STENCIL_TEST):W(n.STENCIL_TEST))},setMask:function(Vt){ut!==Vt&&!k&&(n.stencilMask(Vt),ut=Vt)},setFunc:function(Vt,ee,Pt){(at!==Vt||At!==ee||St!==Pt)&&(n.stencilFunc(Vt,ee,Pt),at=Vt,At=ee,St=Pt)},setOp:function(Vt,ee,Pt){(Et!==Vt||qt!==ee||te!==Pt)&&(n.stencilOp(Vt,ee,Pt),Et=Vt,qt=ee,te=Pt)},setLocked:function(Vt){k=Vt},setClear:function(Vt){_t!==Vt&&(n.clearStencil(Vt),_t=Vt)},reset:function(){k=!1,ut=null,at=null,At=null,St=null,Et=null,qt=null,te=null,_t=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},p=new WeakMap,m=[],x=null,g=!1,d=null,y=null,P=null,S=null,R=null,M=null,_=null,b=new re(0,0,0),D=0,A=!1,E=null,N=null,F=null,I=null,B=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ht=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(Y)[1]),z=ht>=1):Y.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),z=ht>=2);let tt=null,rt={},Q=n.getParameter(n.SCISSOR_BOX),st=n.getParameter(n.VIEWPORT),$=new $e().fromArray(Q),ft=new $e().fromArray(st);function it(k,ut,at,At){let St=new Uint8Array(4),Et=n.createTexture();n.bindTexture(k,Et),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qt=0;qt<at;qt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(ut,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,St):n.texImage2D(ut+qt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,St);return Et}let gt={};gt[n.TEXTURE_2D]=it(n.TEXTURE_2D,n.TEXTURE_2D,1),gt[n.TEXTURE_CUBE_MAP]=it(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[n.TEXTURE_2D_ARRAY]=it(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),gt[n.TEXTURE_3D]=it(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),mt(n.DEPTH_TEST),o.setFunc(Jr),ze(!1),ve(_u),mt(n.CULL_FACE),he(lr);function mt(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function W(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function nt(k,ut){return h[k]!==ut?(n.bindFramebuffer(k,ut),h[k]=ut,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ut),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ut),!0):!1}function lt(k,ut){let at=m,At=!1;if(k){at=p.get(ut),at===void 0&&(at=[],p.set(ut,at));let St=k.textures;if(at.length!==St.length||at[0]!==n.COLOR_ATTACHMENT0){for(let Et=0,qt=St.length;Et<qt;Et++)at[Et]=n.COLOR_ATTACHMENT0+Et;at.length=St.length,At=!0}}else at[0]!==n.BACK&&(at[0]=n.BACK,At=!0);At&&n.drawBuffers(at)}function Dt(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let Ot={[cr]:n.FUNC_ADD,[tp]:n.FUNC_SUBTRACT,[ep]:n.FUNC_REVERSE_SUBTRACT};Ot[np]=n.MIN,Ot[ip]=n.MAX;let Xt={[sp]:n.ZERO,[rp]:n.ONE,[op]:n.SRC_COLOR,[Su]:n.SRC_ALPHA,[fp]:n.SRC_ALPHA_SATURATE,[hp]:n.DST_COLOR,[lp]:n.DST_ALPHA,[ap]:n.ONE_MINUS_SRC_COLOR,[Mu]:n.ONE_MINUS_SRC_ALPHA,[up]:n.ONE_MINUS_DST_COLOR,[cp]:n.ONE_MINUS_DST_ALPHA,[dp]:n.CONSTANT_COLOR,[pp]:n.ONE_MINUS_CONSTANT_COLOR,[mp]:n.CONSTANT_ALPHA,[gp]:n.ONE_MINUS_CONSTANT_ALPHA};function he(k,ut,at,At,St,Et,qt,te,_t,Vt){if(k===lr){g===!0&&(W(n.BLEND),g=!1);return}if(g===!1&&(mt(n.BLEND),g=!0),k!==Qd){if(k!==d||Vt!==A){if((y!==cr||R!==cr)&&(n.blendEquation(n.FUNC_ADD),y=cr,R=cr),Vt)switch(k){case co:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case xu:n.blendFunc(n.ONE,n.ONE);break;case yu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case vu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qt("WebGLState: Invalid blending: ",k);break}else switch(k){case co:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case xu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case yu:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case vu:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",k);break}P=null,S=null,M=null,_=null,b.set(0,0,0),D=0,d=k,A=Vt}return}St=St||ut,Et=Et||at,qt=qt||At,(ut!==y||St!==R)&&(n.blendEquationSeparate(Ot[ut],Ot[St]),y=ut,R=St),(at!==P||At!==S||Et!==M||qt!==_)&&(n.blendFuncSeparate(Xt[at],Xt[At],Xt[Et],Xt[qt]),P=at,S=At,M=Et,_=qt),(te.equals(b)===!1||_t!==D)&&(n.blendColor(te.r,te.g,te.b,_t),b.copy(te),D=_t),d=k,A=!1}function ye(k,ut){k.side===gi?W(n.CULL_FACE):mt(n.CULL_FACE);let at=k.side===Un;ut&&(at=!at),ze(at),k.blending===co&&k.transparent===!1?he(lr):he(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let At=k.stencilWrite;a.setTest(At),At&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),me(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?mt(n.SAMPLE_ALPHA_TO_COVERAGE):W(n.SAMPLE_ALPHA_TO_COVERAGE)}function ze(k){E!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),E=k)}function ve(k){k!==Jd?(mt(n.CULL_FACE),k!==N&&(k===_u?n.cullFace(n.BACK):k===Kd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):W(n.CULL_FACE),N=k}function Ke(k){k!==F&&(z&&n.lineWidth(k),F=k)}function me(k,ut,at){k?(mt(n.POLYGON_OFFSET_FILL),(I!==ut||B!==at)&&(I=ut,B=at,o.getReversed()&&(ut=-ut,at=-at),n.polygonOffset(ut,at))):W(n.POLYGON_OFFSET_FILL)}function sn(k){k?mt(n.SCISSOR_TEST):W(n.SCISSOR_TEST)}function Ne(k){k===void 0&&(k=n.TEXTURE0+X-1),tt!==k&&(n.activeTexture(k),tt=k)}function je(k,ut,at){at===void 0&&(tt===null?at=n.TEXTURE0+X-1:at=tt);let At=rt[at];At===void 0&&(At={type:void 0,texture:void 0},rt[at]=At),(At.type!==k||At.texture!==ut)&&(tt!==at&&(n.activeTexture(at),tt=at),n.bindTexture(k,ut||gt[k]),At.type=k,At.texture=ut)}function V(){let k=rt[tt];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function It(){try{n.compressedTexImage2D(...arguments)}catch(k){Qt("WebGLState:",k)}}function Kt(){try{n.compressedTexImage3D(...arguments)}catch(k){Qt("WebGLState:",k)}}function oe(){try{n.texSubImage2D(...arguments)}catch(k){Qt("WebGLState:",k)}}function Tt(){try{n.texSubImage3D(...arguments)}catch(k){Qt("WebGLState:",k)}}function Ue(){try{n.compressedTexSubImage2D(...arguments)}catch(k){Qt("WebGLState:",k)}}function Wt(){try{n.compressedTexSubImage3D(...arguments)}catch(k){Qt("WebGLState:",k)}}function Zt(){try{n.texStorage2D(...arguments)}catch(k){Qt("WebGLState:",k)}}function L(){try{n.texStorage3D(...arguments)}catch(k){Qt("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){Qt("WebGLState:",k)}}function Z(){try{n.texImage3D(...arguments)}catch(k){Qt("WebGLState:",k)}}function xt(k){return f[k]!==void 0?f[k]:n.getParameter(k)}function dt(k,ut){f[k]!==ut&&(n.pixelStorei(k,ut),f[k]=ut)}function Mt(k){$.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),$.copy(k))}function bt(k){ft.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ft.copy(k))}function ot(k,ut){let at=c.get(ut);at===void 0&&(at=new WeakMap,c.set(ut,at));let At=at.get(k);At===void 0&&(At=n.getUniformBlockIndex(ut,k.name),n.uniformBlockBinding(ut,At,At),at.set(k,At))}function ct(k,ut,at){let St=c.get(ut).get(k);l[St]!==at&&(n.bindBufferBase(n.UNIFORM_BUFFER,St,at),l[St]=at)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},tt=null,rt={},h={},l={},p=new WeakMap,m=[],x=null,g=!1,d=null,y=null,P=null,S=null,R=null,M=null,_=null,b=new re(0,0,0),D=0,A=!1,E=null,N=null,F=null,I=null,B=null,$.set(0,0,n.canvas.width,n.canvas.height),ft.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:mt,disable:W,bindFramebuffer:nt,drawBuffers:lt,useProgram:Dt,setBlending:he,setMaterial:ye,setFlipSided:ze,setCullFace:ve,setLineWidth:Ke,setPolygonOffset:me,setScissorTest:sn,activeTexture:Ne,bindTexture:je,unbindTexture:V,compressedTexImage2D:It,compressedTexImage3D:Kt,texImage2D:w,texImage3D:Z,pixelStorei:dt,getParameter:xt,updateUBOMapping:ot,uniformBlockBinding:ct,texStorage2D:Zt,texStorage3D:L,texSubImage2D:oe,texSubImage3D:Tt,compressedTexSubImage2D:Ue,compressedTexSubImage3D:Wt,scissor:Mt,viewport:bt,reset:vt}}function EM(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,u=new WeakMap,f=new Set,h,p=new WeakMap,m=new Set,x=new FinalizationRegistry(L=>m.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function d(L,w){return g?new OffscreenCanvas(L,w):Yo("canvas")}function y(L,w,Z){let xt=1,dt=Zt(L);if((dt.width>Z||dt.height>Z)&&(xt=Z/Math.max(dt.width,dt.height)),xt<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let Mt=Math.floor(xt*dt.width),bt=Math.floor(xt*dt.height);h===void 0&&(h=d(Mt,bt));let ot=w?d(Mt,bt):h;return ot.width=Mt,ot.height=bt,ot.getContext("2d").drawImage(L,0,0,Mt,bt),Jt("WebGLRenderer: Texture has been resized from ("+dt.width+"x"+dt.height+") to ("+Mt+"x"+bt+")."),ot}else return"data"in L&&Jt("WebGLRenderer: Image in DataTexture is too big ("+dt.width+"x"+dt.height+")."),L;return L}function P(L){return L.generateMipmaps}function S(L){n.generateMipmap(L)}function R(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(L,w,Z,xt,dt,Mt=!1){if(L!==null){if(n[L]!==void 0)return n[L];Jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let bt;xt&&(bt=t.get("EXT_texture_norm16"),bt||Jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ot=w;if(w===n.RED&&(Z===n.FLOAT&&(ot=n.R32F),Z===n.HALF_FLOAT&&(ot=n.R16F),Z===n.UNSIGNED_BYTE&&(ot=n.R8),Z===n.UNSIGNED_SHORT&&bt&&(ot=bt.R16_EXT),Z===n.SHORT&&bt&&(ot=bt.R16_SNORM_EXT)),w===n.RED_INTEGER&&(Z===n.UNSIGNED_BYTE&&(ot=n.R8UI),Z===n.UNSIGNED_SHORT&&(ot=n.R16UI),Z===n.UNSIGNED_INT&&(ot=n.R32UI),Z===n.BYTE&&(ot=n.R8I),Z===n.SHORT&&(ot=n.R16I),Z===n.INT&&(ot=n.R32I)),w===n.RG&&(Z===n.FLOAT&&(ot=n.RG32F),Z===n.HALF_FLOAT&&(ot=n.RG16F),Z===n.UNSIGNED_BYTE&&(ot=n.RG8),Z===n.UNSIGNED_SHORT&&bt&&(ot=bt.RG16_EXT),Z===n.SHORT&&bt&&(ot=bt.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(Z===n.UNSIGNED_BYTE&&(ot=n.RG8UI),Z===n.UNSIGNED_SHORT&&(ot=n.RG16UI),Z===n.UNSIGNED_INT&&(ot=n.RG32UI),Z===n.BYTE&&(ot=n.RG8I),Z===n.SHORT&&(ot=n.RG16I),Z===n.INT&&(ot=n.RG32I)),w===n.RGB_INTEGER&&(Z===n.UNSIGNED_BYTE&&(ot=n.RGB8UI),Z===n.UNSIGNED_SHORT&&(ot=n.RGB16UI),Z===n.UNSIGNED_INT&&(ot=n.RGB32UI),Z===n.BYTE&&(ot=n.RGB8I),Z===n.SHORT&&(ot=n.RGB16I),Z===n.INT&&(ot=n.RGB32I)),w===n.RGBA_INTEGER&&(Z===n.UNSIGNED_BYTE&&(ot=n.RGBA8UI),Z===n.UNSIGNED_SHORT&&(ot=n.RGBA16UI),Z===n.UNSIGNED_INT&&(ot=n.RGBA32UI),Z===n.BYTE&&(ot=n.RGBA8I),Z===n.SHORT&&(ot=n.RGBA16I),Z===n.INT&&(ot=n.RGBA32I)),w===n.RGB&&(Z===n.UNSIGNED_SHORT&&bt&&(ot=bt.RGB16_EXT),Z===n.SHORT&&bt&&(ot=bt.RGB16_SNORM_EXT),Z===n.UNSIGNED_INT_5_9_9_9_REV&&(ot=n.RGB9_E5),Z===n.UNSIGNED_INT_10F_11F_11F_REV&&(ot=n.R11F_G11F_B10F)),w===n.RGBA){let ct=Mt?qo:_e.getTransfer(dt);Z===n.FLOAT&&(ot=n.RGBA32F),Z===n.HALF_FLOAT&&(ot=n.RGBA16F),Z===n.UNSIGNED_BYTE&&(ot=ct===Ce?n.SRGB8_ALPHA8:n.RGBA8),Z===n.UNSIGNED_SHORT&&bt&&(ot=bt.RGBA16_EXT),Z===n.SHORT&&bt&&(ot=bt.RGBA16_SNORM_EXT),Z===n.UNSIGNED_SHORT_4_4_4_4&&(ot=n.RGBA4),Z===n.UNSIGNED_SHORT_5_5_5_1&&(ot=n.RGB5_A1)}return(ot===n.R16F||ot===n.R32F||ot===n.RG16F||ot===n.RG32F||ot===n.RGBA16F||ot===n.RGBA32F)&&t.get("EXT_color_buffer_float"),ot}function _(L,w){let Z;return L?w===null||w===Ci||w===ur?Z=n.DEPTH24_STENCIL8:w===Ri?Z=n.DEPTH32F_STENCIL8:w===uo&&(Z=n.DEPTH24_STENCIL8,Jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ci||w===ur?Z=n.DEPTH_COMPONENT24:w===Ri?Z=n.DEPTH_COMPONENT32F:w===uo&&(Z=n.DEPTH_COMPONENT16),Z}function b(L,w){return P(L)===!0||L.isFramebufferTexture&&L.minFilter!==Rn&&L.minFilter!==Dn?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function D(L){let w=new WeakRef(L);i.get(L).__ref=w,m.add(w),x.register(L,w,w)}function A(L){let w=i.get(L).__ref;w!==void 0&&(m.delete(w),x.unregister(w))}function E(L){F(L.target)}function N(L){I(L.target)}function F(L){L.removeEventListener("dispose",E),A(L),X(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&f.delete(L)}function I(L){L.removeEventListener("dispose",N),A(L),ht(L)}function B(){for(let L of m){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):F(w))}m.clear(),f.clear()}function X(L){let w=i.get(L);if(w.__webglInit===void 0)return;let Z=L.source,xt=p.get(Z);if(xt){let dt=xt[w.__cacheKey];dt.usedTimes--,dt.usedTimes===0&&z(L),Object.keys(xt).length===0&&p.delete(Z)}i.remove(L)}function z(L){let w=i.get(L);n.deleteTexture(w.__webglTexture);let Z=L.source,xt=p.get(Z);delete xt[w.__cacheKey],o.memory.textures--}function ht(L){let w=i.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let Z=L.depthTexture;if(Z&&Z.renderTarget===L&&F(Z),L.isWebGLCubeRenderTarget)for(let dt=0;dt<6;dt++){if(Array.isArray(w.__webglFramebuffer[dt]))for(let Mt=0;Mt<w.__webglFramebuffer[dt].length;Mt++)n.deleteFramebuffer(w.__webglFramebuffer[dt][Mt]);else n.deleteFramebuffer(w.__webglFramebuffer[dt]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[dt])}else{if(Array.isArray(w.__webglFramebuffer))for(let dt=0;dt<w.__webglFramebuffer.length;dt++)n.deleteFramebuffer(w.__webglFramebuffer[dt]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let dt=0;dt<w.__webglColorRenderbuffer.length;dt++)w.__webglColorRenderbuffer[dt]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[dt]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let xt=L.textures;for(let dt=0,Mt=xt.length;dt<Mt;dt++){let bt=i.get(xt[dt]);bt.__webglTexture&&(n.deleteTexture(bt.__webglTexture),o.memory.textures--),i.remove(xt[dt])}i.remove(L)}let Y=0;function tt(){Y=0}function rt(){return Y}function Q(L){Y=L}function st(){let L=Y;return L>=s.maxTextures&&Jt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,L}function $(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function ft(L,w){let Z=i.get(L);if(L.isVideoTexture&&Ue(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Z.__version!==L.version){let xt=L.image;if(xt===null)Jt("WebGLRenderer: Texture marked for update but no image data found.");else if(xt.complete===!1)Jt("WebGLRenderer: Texture marked for update but image is incomplete");else{ye(Z,L,w);return}}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Z.__webglTexture,n.TEXTURE0+w)}function it(L,w){let Z=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){ye(Z,L,w);return}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Z.__webglTexture,n.TEXTURE0+w)}function gt(L,w){let Z=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){ye(Z,L,w);return}e.bindTexture(n.TEXTURE_3D,Z.__webglTexture,n.TEXTURE0+w)}function mt(L,w){let Z=i.get(L);if(L.version>0&&Z.__version!==L.version){ze(Z,L,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture,n.TEXTURE0+w)}let W={[Tl]:n.REPEAT,[Xi]:n.CLAMP_TO_EDGE,[Al]:n.MIRRORED_REPEAT},nt={[Rn]:n.NEAREST,[yp]:n.NEAREST_MIPMAP_NEAREST,[ga]:n.NEAREST_MIPMAP_LINEAR,[Dn]:n.LINEAR,[tc]:n.LINEAR_MIPMAP_NEAREST,[_s]:n.LINEAR_MIPMAP_LINEAR},lt={[bp]:n.NEVER,[ku]:n.ALWAYS,[wp]:n.LESS,[Bu]:n.LEQUAL,[Ep]:n.EQUAL,[zu]:n.GEQUAL,[Tp]:n.GREATER,[Ap]:n.NOTEQUAL};function Dt(L,w){if(w.type===Ri&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===Dn||w.magFilter===tc||w.magFilter===ga||w.magFilter===_s||w.minFilter===Dn||w.minFilter===tc||w.minFilter===ga||w.minFilter===_s)&&Jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,W[w.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,W[w.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,W[w.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,nt[w.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,nt[w.minFilter]),w.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,lt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Rn||w.minFilter!==ga&&w.minFilter!==_s||w.type===Ri&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function Ot(L,w){let Z=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",E),D(w));let xt=w.source,dt=p.get(xt);dt===void 0&&(dt={},p.set(xt,dt));let Mt=$(w);if(Mt!==L.__cacheKey){dt[Mt]===void 0&&(dt[Mt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),dt[Mt].usedTimes++;let bt=dt[L.__cacheKey];bt!==void 0&&(dt[L.__cacheKey].usedTimes--,bt.usedTimes===0&&z(w)),L.__cacheKey=Mt,L.__webglTexture=dt[Mt].texture}return Z}function Xt(L,w,Z){return Math.floor(Math.floor(L/Z)/w)}function he(L,w,Z,xt){let Mt=L.updateRanges;if(Mt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,Z,xt,w.data);else{Mt.sort((k,ut)=>k.start-ut.start);let bt=0;for(let k=1;k<Mt.length;k++){let ut=Mt[bt],at=Mt[k],At=ut.start+ut.count,St=Xt(at.start,w.width,4),Et=Xt(ut.start,w.width,4);at.start<=At+1&&St===Et&&Xt(at.start+at.count-1,w.width,4)===St?ut.count=Math.max(ut.count,at.start+at.count-ut.start):(++bt,Mt[bt]=at)}Mt.length=bt+1;let ot=e.getParameter(n.UNPACK_ROW_LENGTH),ct=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,ut=Mt.length;k<ut;k++){let at=Mt[k],At=Math.floor(at.start/4),St=Math.ceil(at.count/4),Et=At%w.width,qt=Math.floor(At/w.width),te=St,_t=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Et),e.pixelStorei(n.UNPACK_SKIP_ROWS,qt),e.texSubImage2D(n.TEXTURE_2D,0,Et,qt,te,_t,Z,xt,w.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,ot),e.pixelStorei(n.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function ye(L,w,Z){let xt=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(xt=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(xt=n.TEXTURE_3D);let dt=Ot(L,w),Mt=w.source;e.bindTexture(xt,L.__webglTexture,n.TEXTURE0+Z);let bt=i.get(Mt);if(Mt.version!==bt.__version||dt===!0){if(e.activeTexture(n.TEXTURE0+Z),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let _t=_e.getPrimaries(_e.workingColorSpace),Vt=w.colorSpace===ys?null:_e.getPrimaries(w.colorSpace),ee=w.colorSpace===ys||_t===Vt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let ct=y(w.image,!1,s.maxTextureSize);ct=Wt(w,ct);let vt=r.convert(w.format,w.colorSpace),k=r.convert(w.type),ut=M(w.internalFormat,vt,k,w.normalized,w.colorSpace,w.isVideoTexture);Dt(xt,w);let at,At=w.mipmaps,St=w.isVideoTexture!==!0,Et=bt.__version===void 0||dt===!0,qt=Mt.dataReady,te=b(w,ct);if(w.isDepthTexture)ut=_(w.format===xs,w.type),Et&&(St?e.texStorage2D(n.TEXTURE_2D,1,ut,ct.width,ct.height):e.texImage2D(n.TEXTURE_2D,0,ut,ct.width,ct.height,0,vt,k,null));else if(w.isDataTexture)if(At.length>0){St&&Et&&e.texStorage2D(n.TEXTURE_2D,te,ut,At[0].width,At[0].height);for(let _t=0,Vt=At.length;_t<Vt;_t++)at=At[_t],St?qt&&e.texSubImage2D(n.TEXTURE_2D,_t,0,0,at.width,at.height,vt,k,at.data):e.texImage2D(n.TEXTURE_2D,_t,ut,at.width,at.height,0,vt,k,at.data);w.generateMipmaps=!1}else St?(Et&&e.texStorage2D(n.TEXTURE_2D,te,ut,ct.width,ct.height),qt&&he(w,ct,vt,k)):e.texImage2D(n.TEXTURE_2D,0,ut,ct.width,ct.height,0,vt,k,ct.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){St&&Et&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,ut,At[0].width,At[0].height,ct.depth);for(let _t=0,Vt=At.length;_t<Vt;_t++)if(at=At[_t],w.format!==Ii)if(vt!==null)if(St){if(qt)if(w.layerUpdates.size>0){let ee=Ku(at.width,at.height,w.format,w.type);for(let Pt of w.layerUpdates){let ae=at.data.subarray(Pt*ee/at.data.BYTES_PER_ELEMENT,(Pt+1)*ee/at.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,_t,0,0,Pt,at.width,at.height,1,vt,ae)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,_t,0,0,0,at.width,at.height,ct.depth,vt,at.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,_t,ut,at.width,at.height,ct.depth,0,at.data,0,0);else Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else St?qt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,_t,0,0,0,at.width,at.height,ct.depth,vt,k,at.data):e.texImage3D(n.TEXTURE_2D_ARRAY,_t,ut,at.width,at.height,ct.depth,0,vt,k,at.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{St&&Et&&e.texStorage2D(n.TEXTURE_2D,te,ut,At[0].width,At[0].height);for(let _t=0,Vt=At.length;_t<Vt;_t++)at=At[_t],w.format!==Ii?vt!==null?St?qt&&e.compressedTexSubImage2D(n.TEXTURE_2D,_t,0,0,at.width,at.height,vt,at.data):e.compressedTexImage2D(n.TEXTURE_2D,_t,ut,at.width,at.height,0,at.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):St?qt&&e.texSubImage2D(n.TEXTURE_2D,_t,0,0,at.width,at.height,vt,k,at.data):e.texImage2D(n.TEXTURE_2D,_t,ut,at.width,at.height,0,vt,k,at.data)}else if(w.isDataArrayTexture)if(St){if(Et&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,ut,ct.width,ct.height,ct.depth),qt)if(w.layerUpdates.size>0){let _t=Ku(ct.width,ct.height,w.format,w.type);for(let Vt of w.layerUpdates){let ee=ct.data.subarray(Vt*_t/ct.data.BYTES_PER_ELEMENT,(Vt+1)*_t/ct.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Vt,ct.width,ct.height,1,vt,k,ee)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ct.width,ct.height,ct.depth,vt,k,ct.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ut,ct.width,ct.height,ct.depth,0,vt,k,ct.data);else if(w.isData3DTexture)St?(Et&&e.texStorage3D(n.TEXTURE_3D,te,ut,ct.width,ct.height,ct.depth),qt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ct.width,ct.height,ct.depth,vt,k,ct.data)):e.texImage3D(n.TEXTURE_3D,0,ut,ct.width,ct.height,ct.depth,0,vt,k,ct.data);else if(w.isFramebufferTexture){if(Et)if(St)e.texStorage2D(n.TEXTURE_2D,te,ut,ct.width,ct.height);else{let _t=ct.width,Vt=ct.height;for(let ee=0;ee<te;ee++)e.texImage2D(n.TEXTURE_2D,ee,ut,_t,Vt,0,vt,k,null),_t>>=1,Vt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let _t=n.canvas;if(_t.hasAttribute("layoutsubtree")||_t.setAttribute("layoutsubtree","true"),ct.parentNode!==_t){_t.appendChild(ct),f.add(w),_t.onpaint=Vt=>{let ee=Vt.changedElements;for(let Pt of f)ee.includes(Pt.image)&&(Pt.needsUpdate=!0)},_t.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ct);else{let ee=n.RGBA,Pt=n.RGBA,ae=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ee,Pt,ae,ct)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(St&&Et){let _t=Zt(At[0]);e.texStorage2D(n.TEXTURE_2D,te,ut,_t.width,_t.height)}for(let _t=0,Vt=At.length;_t<Vt;_t++)at=At[_t],St?qt&&e.texSubImage2D(n.TEXTURE_2D,_t,0,0,vt,k,at):e.texImage2D(n.TEXTURE_2D,_t,ut,vt,k,at);w.generateMipmaps=!1}else if(St){if(Et){let _t=Zt(ct);e.texStorage2D(n.TEXTURE_2D,te,ut,_t.width,_t.height)}qt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,k,ct)}else e.texImage2D(n.TEXTURE_2D,0,ut,vt,k,ct);P(w)&&w.mipmapsAutoUpdate===!0&&S(xt),bt.__version=Mt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function ze(L,w,Z){if(w.image.length!==6)return;let xt=Ot(L,w),dt=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+Z);let Mt=i.get(dt);if(dt.version!==Mt.__version||xt===!0){e.activeTexture(n.TEXTURE0+Z);let bt=_e.getPrimaries(_e.workingColorSpace),ot=w.colorSpace===ys?null:_e.getPrimaries(w.colorSpace),ct=w.colorSpace===ys||bt===ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ct);let vt=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,ut=[];for(let Pt=0;Pt<6;Pt++)!vt&&!k?ut[Pt]=y(w.image[Pt],!0,s.maxCubemapSize):ut[Pt]=k?w.image[Pt].image:w.image[Pt],ut[Pt]=Wt(w,ut[Pt]);let at=ut[0],At=r.convert(w.format,w.colorSpace),St=r.convert(w.type),Et=M(w.internalFormat,At,St,w.normalized,w.colorSpace),qt=w.isVideoTexture!==!0,te=Mt.__version===void 0||xt===!0,_t=dt.dataReady,Vt=b(w,at);Dt(n.TEXTURE_CUBE_MAP,w);let ee;if(w.isDepthTexture){if(Et=_(w.format===xs,w.type),te)if(qt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Et,at.width,at.height);else for(let Pt=0;Pt<6;Pt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,Et,at.width,at.height,0,At,St,null)}else if(vt){qt&&te&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Vt,Et,at.width,at.height);for(let Pt=0;Pt<6;Pt++){ee=ut[Pt].mipmaps;for(let ae=0;ae<ee.length;ae++){let ke=ee[ae];w.format!==Ii?At!==null?qt?_t&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae,0,0,ke.width,ke.height,At,ke.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae,Et,ke.width,ke.height,0,ke.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?_t&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae,0,0,ke.width,ke.height,At,St,ke.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae,Et,ke.width,ke.height,0,At,St,ke.data)}}}else{if(ee=w.mipmaps,qt&&te){ee.length>0&&Vt++;let Pt=Zt(ut[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Vt,Et,Pt.width,Pt.height)}for(let Pt=0;Pt<6;Pt++)if(k){qt?_t&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,0,0,ut[Pt].width,ut[Pt].height,At,St,ut[Pt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,Et,ut[Pt].width,ut[Pt].height,0,At,St,ut[Pt].data);for(let ae=0;ae<ee.length;ae++){let Gn=ee[ae].image[Pt].image;qt?_t&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae+1,0,0,Gn.width,Gn.height,At,St,Gn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae+1,Et,Gn.width,Gn.height,0,At,St,Gn.data)}}else{qt?_t&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,0,0,At,St,ut[Pt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,Et,At,St,ut[Pt]);for(let ae=0;ae<ee.length;ae++){let ke=ee[ae];qt?_t&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae+1,0,0,At,St,ke.image[Pt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ae+1,Et,At,St,ke.image[Pt])}}}P(w)&&w.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),Mt.__version=dt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function ve(L,w,Z,xt,dt,Mt){let bt=r.convert(Z.format,Z.colorSpace),ot=r.convert(Z.type),ct=M(Z.internalFormat,bt,ot,Z.normalized,Z.colorSpace),vt=i.get(w),k=i.get(Z);if(k.__renderTarget=w,!vt.__hasExternalTextures){let ut=Math.max(1,w.width>>Mt),at=Math.max(1,w.height>>Mt);dt===n.TEXTURE_3D||dt===n.TEXTURE_2D_ARRAY?e.texImage3D(dt,Mt,ct,ut,at,w.depth,0,bt,ot,null):e.texImage2D(dt,Mt,ct,ut,at,0,bt,ot,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),Tt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xt,dt,k.__webglTexture,0,oe(w)):(dt===n.TEXTURE_2D||dt>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&dt<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,xt,dt,k.__webglTexture,Mt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ke(L,w,Z){if(n.bindRenderbuffer(n.RENDERBUFFER,L),w.depthBuffer){let xt=w.depthTexture,dt=xt&&xt.isDepthTexture?xt.type:null,Mt=_(w.stencilBuffer,dt),bt=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Tt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,oe(w),Mt,w.width,w.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,oe(w),Mt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,Mt,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,bt,n.RENDERBUFFER,L)}else{let xt=w.textures;for(let dt=0;dt<xt.length;dt++){let Mt=xt[dt],bt=r.convert(Mt.format,Mt.colorSpace),ot=r.convert(Mt.type),ct=M(Mt.internalFormat,bt,ot,Mt.normalized,Mt.colorSpace);Tt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,oe(w),ct,w.width,w.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,oe(w),ct,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ct,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function me(L,w,Z){let xt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let dt=i.get(w.depthTexture);dt.__renderTarget=w;let Mt=xt?w.depthTexture.image[0]:w.depthTexture.image;(!dt.__webglTexture||Mt.width!==w.width||Mt.height!==w.height)&&(Mt.width=w.width,Mt.height=w.height,w.depthTexture.needsUpdate=!0),xt?mt(w.depthTexture,0):ft(w.depthTexture,0);let bt=dt.__webglTexture,ot=oe(w),ct=xt?n.TEXTURE_CUBE_MAP_POSITIVE_X+Z:n.TEXTURE_2D,vt=w.depthTexture.format===xs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===us)Tt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,ct,bt,0,ot):n.framebufferTexture2D(n.FRAMEBUFFER,vt,ct,bt,0);else if(w.depthTexture.format===xs)Tt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,ct,bt,0,ot):n.framebufferTexture2D(n.FRAMEBUFFER,vt,ct,bt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function sn(L){let w=i.get(L),Z=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let xt=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),xt){let dt=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,xt.removeEventListener("dispose",dt)};xt.addEventListener("dispose",dt),w.__depthDisposeCallback=dt}w.__boundDepthTexture=xt}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if(Z)for(let xt=0;xt<6;xt++)me(w.__webglFramebuffer[xt],L,xt);else L.texture.mipmaps.length>0?me(w.__webglFramebuffer[0],L,0):me(w.__webglFramebuffer,L,0);else if(Z){w.__webglDepthbuffer=[];for(let xt=0;xt<6;xt++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[xt]),w.__webglDepthbuffer[xt]===void 0)w.__webglDepthbuffer[xt]=n.createRenderbuffer(),Ke(w.__webglDepthbuffer[xt],L,!1);else{let dt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=w.__webglDepthbuffer[xt];n.bindRenderbuffer(n.RENDERBUFFER,Mt),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,Mt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Ke(w.__webglDepthbuffer,L,!1);else{let dt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,Mt),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,Mt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ne(L,w,Z){let xt=i.get(L);w!==void 0&&ve(xt.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Z!==void 0&&sn(L)}function je(L){let w=L.texture,Z=i.get(L),xt=i.get(w);L.addEventListener("dispose",N),D(L);let dt=L.textures,Mt=L.isWebGLCubeRenderTarget===!0,bt=dt.length>1;if(bt||(xt.__webglTexture===void 0&&(xt.__webglTexture=n.createTexture()),xt.__version=w.version,o.memory.textures++),Mt){Z.__webglFramebuffer=[];for(let ot=0;ot<6;ot++)if(w.mipmaps.length>0){Z.__webglFramebuffer[ot]=[];for(let ct=0;ct<w.mipmaps.length;ct++)Z.__webglFramebuffer[ot][ct]=n.createFramebuffer()}else Z.__webglFramebuffer[ot]=n.createFramebuffer()}else{if(w.mipmaps.length>0){Z.__webglFramebuffer=[];for(let ot=0;ot<w.mipmaps.length;ot++)Z.__webglFramebuffer[ot]=n.createFramebuffer()}else Z.__webglFramebuffer=n.createFramebuffer();if(bt)for(let ot=0,ct=dt.length;ot<ct;ot++){let vt=i.get(dt[ot]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&Tt(L)===!1){Z.__webglMultisampledFramebuffer=n.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let ot=0;ot<dt.length;ot++){let ct=dt[ot];Z.__webglColorRenderbuffer[ot]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Z.__webglColorRenderbuffer[ot]);let vt=r.convert(ct.format,ct.colorSpace),k=r.convert(ct.type),ut=M(ct.internalFormat,vt,k,ct.normalized,ct.colorSpace,L.isXRRenderTarget===!0),at=oe(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,at,ut,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ot,n.RENDERBUFFER,Z.__webglColorRenderbuffer[ot])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&(Z.__webglDepthRenderbuffer=n.createRenderbuffer(),Ke(Z.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(Mt){e.bindTexture(n.TEXTURE_CUBE_MAP,xt.__webglTexture),Dt(n.TEXTURE_CUBE_MAP,w);for(let ot=0;ot<6;ot++)if(w.mipmaps.length>0)for(let ct=0;ct<w.mipmaps.length;ct++)ve(Z.__webglFramebuffer[ot][ct],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ot,ct);else ve(Z.__webglFramebuffer[ot],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ot,0);P(w)?S(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(bt){for(let ot=0,ct=dt.length;ot<ct;ot++){let vt=dt[ot],k=i.get(vt),ut=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ut=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,k.__webglTexture),Dt(ut,vt),ve(Z.__webglFramebuffer,L,vt,n.COLOR_ATTACHMENT0+ot,ut,0),P(vt)&&S(ut)}e.unbindTexture()}else{let ot=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ot=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,xt.__webglTexture),Dt(ot,w),w.mipmaps.length>0)for(let ct=0;ct<w.mipmaps.length;ct++)ve(Z.__webglFramebuffer[ct],L,w,n.COLOR_ATTACHMENT0,ot,ct);else ve(Z.__webglFramebuffer,L,w,n.COLOR_ATTACHMENT0,ot,0);P(w)?S(ot):w.mipmaps.length>0&&n.texParameteri(ot,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&sn(L)}function V(L){let w=L.textures;for(let Z=0,xt=w.length;Z<xt;Z++){let dt=w[Z];if(P(dt)&&dt.mipmapsAutoUpdate===!0){let Mt=R(L),bt=i.get(dt).__webglTexture;e.bindTexture(Mt,bt),S(Mt),e.unbindTexture()}}}let It=[];function Kt(L){if(L.samples>0){if(Tt(L)===!1){let w=L.textures,Z=L.width,xt=L.height,dt=n.COLOR_BUFFER_BIT,Mt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=i.get(L),ot=w.length>1;if(ot)for(let vt=0;vt<w.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,bt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglFramebuffer);for(let vt=0;vt<w.length;vt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(dt|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(dt|=n.STENCIL_BUFFER_BIT)),ot){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,bt.__webglColorRenderbuffer[vt]);let k=i.get(w[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,Z,xt,0,0,Z,xt,dt,n.NEAREST),l===!0&&(It.length=0,It.push(n.COLOR_ATTACHMENT0+vt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&It.push(Mt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,It))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ot)for(let vt=0;vt<w.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,bt.__webglColorRenderbuffer[vt]);let k=i.get(w[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,k,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let w=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function oe(L){return Math.min(s.maxSamples,L.samples)}function Tt(L){let w=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ue(L){let w=o.render.frame;u.get(L)!==w&&(u.set(L,w),L.update())}function Wt(L,w){let Z=L.colorSpace,xt=L.format,dt=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Z!==Xo&&Z!==ys&&(_e.getTransfer(Z)===Ce?(xt!==Ii||dt!==jn)&&Jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",Z)),w}function Zt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=st,this.resetTextureUnits=tt,this.getTextureUnits=rt,this.setTextureUnits=Q,this.setTexture2D=ft,this.setTexture2DArray=it,this.setTexture3D=gt,this.setTextureCube=mt,this.rebindTextures=Ne,this.setupRenderTarget=je,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Kt,this.setupDepthRenderbuffer=sn,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=Tt,this.dispose=B}function TM(n,t){function e(i,s=ys){let r,o=_e.getTransfer(s);if(i===jn)return n.UNSIGNED_BYTE;if(i===nc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ic)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Du)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Nu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Iu)return n.BYTE;if(i===Lu)return n.SHORT;if(i===uo)return n.UNSIGNED_SHORT;if(i===ec)return n.INT;if(i===Ci)return n.UNSIGNED_INT;if(i===Ri)return n.FLOAT;if(i===Pi)return n.HALF_FLOAT;if(i===Uu)return n.ALPHA;if(i===Fu)return n.RGB;if(i===Ii)return n.RGBA;if(i===us)return n.DEPTH_COMPONENT;if(i===xs)return n.DEPTH_STENCIL;if(i===Ou)return n.RED;if(i===sc)return n.RED_INTEGER;if(i===Xs)return n.RG;if(i===rc)return n.RG_INTEGER;if(i===oc)return n.RGBA_INTEGER;if(i===_a||i===xa||i===ya||i===va)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===_a)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===_a)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===xa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ac||i===lc||i===cc||i===hc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ac)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===lc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===cc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===hc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===uc||i===fc||i===dc||i===pc||i===mc||i===Sa||i===gc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===uc||i===fc)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===dc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===pc)return r.COMPRESSED_R11_EAC;if(i===mc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Sa)return r.COMPRESSED_RG11_EAC;if(i===gc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===_c||i===xc||i===yc||i===vc||i===Sc||i===Mc||i===bc||i===wc||i===Ec||i===Tc||i===Ac||i===Cc||i===Rc||i===Pc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===_c)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===xc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===yc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===vc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Sc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Mc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===bc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===wc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ec)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Tc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ac)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Cc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Rc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Pc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ic||i===Lc||i===Dc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ic)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Lc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Dc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Nc||i===Uc||i===Ma||i===Fc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Nc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Uc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ma)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Fc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ur?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var AM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,CM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,af=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new sa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Zi({vertexShader:AM,fragmentShader:CM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ee(new oa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},lf=class extends Ti{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,p=null,m=null,x=typeof XRWebGLBinding<"u",g=new af,d={},y=e.getContextAttributes(),P=null,S=null,R=[],M=[],_=new Yt,b=null,D=null,A=new $n;A.viewport=new $e;let E=new $n;E.viewport=new $e;let N=[A,E],F=new Jl,I=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let ft=R[$];return ft===void 0&&(ft=new no,R[$]=ft),ft.getTargetRaySpace()},this.getControllerGrip=function($){let ft=R[$];return ft===void 0&&(ft=new no,R[$]=ft),ft.getGripSpace()},this.getHand=function($){let ft=R[$];return ft===void 0&&(ft=new no,R[$]=ft),ft.getHandSpace()};function X($){let ft=M.indexOf($.inputSource);if(ft===-1)return;let it=R[ft];it!==void 0&&(it.update($.inputSource,$.frame,c||o),it.dispatchEvent({type:$.type,data:$.inputSource}))}function z(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ht);for(let $=0;$<R.length;$++){let ft=M[$];ft!==null&&(M[$]=null,R[$].disconnect(ft))}I=null,B=null,g.reset();for(let $ in d)delete d[$];if(t.setRenderTarget(P),p=null,h=null,f=null,s=null,S=null,st.stop(),i.isPresenting=!1,t.setPixelRatio(b),t.setSize(_.width,_.height,!1),D!==null){let $=D.camera;$.fov=D.fov,$.zoom=D.zoom,$.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,i.isPresenting===!0&&Jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&Jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return h!==null?h:p},this.getBinding=function(){return f===null&&x&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(P=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ht),y.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let it=null,gt=null,mt=null;y.depth&&(mt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,it=y.stencil?xs:us,gt=y.stencil?ur:Ci);let W={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(W),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),S=new oi(h.textureWidth,h.textureHeight,{format:Ii,type:jn,depthTexture:new ms(h.textureWidth,h.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,it),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let it={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,it),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new oi(p.framebufferWidth,p.framebufferHeight,{format:Ii,type:jn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),st.setContext(s),st.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ht($){for(let ft=0;ft<$.removed.length;ft++){let it=$.removed[ft],gt=M.indexOf(it);gt>=0&&(M[gt]=null,R[gt].disconnect(it))}for(let ft=0;ft<$.added.length;ft++){let it=$.added[ft],gt=M.indexOf(it);if(gt===-1){for(let W=0;W<R.length;W++)if(W>=M.length){M.push(it),gt=W;break}else if(M[W]===null){M[W]=it,gt=W;break}if(gt===-1)break}let mt=R[gt];mt&&mt.connect(it)}}function Y($,ft){ft===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(ft.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let ft=$.near,it=$.far;g.texture!==null&&(g.depthNear>0&&(ft=g.depthNear),g.depthFar>0&&(it=g.depthFar)),F.near=E.near=A.near=ft,F.far=E.far=A.far=it,(I!==F.near||B!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),I=F.near,B=F.far),F.layers.mask=$.layers.mask|6,A.layers.mask=F.layers.mask&-5,E.layers.mask=F.layers.mask&-3;let gt=$.parent,mt=F.cameras;Y(F,gt);for(let W=0;W<mt.length;W++)Y(mt[W],gt);F.projectionMatrix.copy(A.projectionMatrix),F.projectionMatrixInverse.copy(A.projectionMatrixInverse),D===null&&$.isPerspectiveCamera&&(D={camera:$,fov:$.fov,zoom:$.zoom}),tt($,F,gt)};function tt($,ft,it){it===null?$.matrix.copy(ft.matrixWorld):($.matrix.copy(it.matrixWorld),$.matrix.invert(),$.matrix.multiply(ft.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(ft.projectionMatrix),$.projectionMatrixInverse.copy(ft.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=Qr*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(h===null&&p===null))return l},this.setFoveation=function($){l=$,h!==null&&(h.fixedFoveation=$),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(F)},this.getCameraTexture=function($){return d[$]};let rt=null;function Q($,ft){if(u=ft.getViewerPose(c||o),m=ft,u!==null){let it=u.views;p!==null&&(t.setRenderTargetFramebuffer(S,p.framebuffer),t.setRenderTarget(S));let gt=!1;it.length!==F.cameras.length&&(F.cameras.length=0,gt=!0);for(let lt=0;lt<it.length;lt++){let Dt=it[lt],Ot=null;if(p!==null)Ot=p.getViewport(Dt);else{let he=f.getViewSubImage(h,Dt);Ot=he.viewport,lt===0&&(t.setRenderTargetTextures(S,he.colorTexture,he.depthStencilTexture),t.setRenderTarget(S))}let Xt=N[lt];Xt===void 0&&(Xt=new $n,Xt.layers.enable(lt),Xt.viewport=new $e,N[lt]=Xt),Xt.matrix.fromArray(Dt.transform.matrix),Xt.matrix.decompose(Xt.position,Xt.quaternion,Xt.scale),Xt.projectionMatrix.fromArray(Dt.projectionMatrix),Xt.projectionMatrixInverse.copy(Xt.projectionMatrix).invert(),Xt.viewport.set(Ot.x,Ot.y,Ot.width,Ot.height),lt===0&&(F.matrix.copy(Xt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),gt===!0&&F.cameras.push(Xt)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){f=i.getBinding();let lt=f.getDepthInformation(it[0]);lt&&lt.isValid&&lt.texture&&g.init(lt,s.renderState)}if(mt&&mt.includes("camera-access")&&x){t.state.unbindTexture(),f=i.getBinding();for(let lt=0;lt<it.length;lt++){let Dt=it[lt].camera;if(Dt){let Ot=d[Dt];Ot||(Ot=new sa,d[Dt]=Ot);let Xt=f.getCameraImage(Dt);Ot.sourceTexture=Xt}}}}for(let it=0;it<R.length;it++){let gt=M[it],mt=R[it];gt!==null&&mt!==void 0&&mt.update(gt,ft,c||o)}rt&&rt($,ft),ft.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ft}),m=null}let st=new sm;st.setAnimationLoop(Q),this.setAnimationLoop=function($){rt=$},this.dispose=function(){}}},RM=new we,pm=new ie;pm.set(-1,0,0,0,1,0,0,0,1);function PM(n,t){function e(g,d){g.matrixAutoUpdate===!0&&g.updateMatrix(),d.value.copy(g.matrix)}function i(g,d){d.color.getRGB(g.fogColor.value,$u(n)),d.isFog?(g.fogNear.value=d.near,g.fogFar.value=d.far):d.isFogExp2&&(g.fogDensity.value=d.density)}function s(g,d,y,P,S){d.isNodeMaterial?d.uniformsNeedUpdate=!1:d.isMeshBasicMaterial?r(g,d):d.isMeshLambertMaterial?(r(g,d),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)):d.isMeshToonMaterial?(r(g,d),f(g,d)):d.isMeshPhongMaterial?(r(g,d),u(g,d),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)):d.isMeshStandardMaterial?(r(g,d),h(g,d),d.isMeshPhysicalMaterial&&p(g,d,S)):d.isMeshMatcapMaterial?(r(g,d),m(g,d)):d.isMeshDepthMaterial?r(g,d):d.isMeshDistanceMaterial?(r(g,d),x(g,d)):d.isMeshNormalMaterial?r(g,d):d.isLineBasicMaterial?(o(g,d),d.isLineDashedMaterial&&a(g,d)):d.isPointsMaterial?l(g,d,y,P):d.isSpriteMaterial?c(g,d):d.isShadowMaterial?(g.color.value.copy(d.color),g.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(g,d){g.opacity.value=d.opacity,d.color&&g.diffuse.value.copy(d.color),d.emissive&&g.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.bumpMap&&(g.bumpMap.value=d.bumpMap,e(d.bumpMap,g.bumpMapTransform),g.bumpScale.value=d.bumpScale,d.side===Un&&(g.bumpScale.value*=-1)),d.normalMap&&(g.normalMap.value=d.normalMap,e(d.normalMap,g.normalMapTransform),g.normalScale.value.copy(d.normalScale),d.side===Un&&g.normalScale.value.negate()),d.displacementMap&&(g.displacementMap.value=d.displacementMap,e(d.displacementMap,g.displacementMapTransform),g.displacementScale.value=d.displacementScale,g.displacementBias.value=d.displacementBias),d.emissiveMap&&(g.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,g.emissiveMapTransform)),d.specularMap&&(g.specularMap.value=d.specularMap,e(d.specularMap,g.specularMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest);let y=t.get(d),P=y.envMap,S=y.envMapRotation;P&&(g.envMap.value=P,g.envMapRotation.value.setFromMatrix4(RM.makeRotationFromEuler(S)).transpose(),P.isCubeTexture&&P.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(pm),g.reflectivity.value=d.reflectivity,g.ior.value=d.ior,g.refractionRatio.value=d.refractionRatio),d.lightMap&&(g.lightMap.value=d.lightMap,g.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,g.lightMapTransform)),d.aoMap&&(g.aoMap.value=d.aoMap,g.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,g.aoMapTransform))}function o(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform))}function a(g,d){g.dashSize.value=d.dashSize,g.totalSize.value=d.dashSize+d.gapSize,g.scale.value=d.scale}function l(g,d,y,P){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.size.value=d.size*y,g.scale.value=P*.5,d.map&&(g.map.value=d.map,e(d.map,g.uvTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function c(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.rotation.value=d.rotation,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function u(g,d){g.specular.value.copy(d.specular),g.shininess.value=Math.max(d.shininess,1e-4)}function f(g,d){d.gradientMap&&(g.gradientMap.value=d.gradientMap)}function h(g,d){g.metalness.value=d.metalness,d.metalnessMap&&(g.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,g.metalnessMapTransform)),g.roughness.value=d.roughness,d.roughnessMap&&(g.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,g.roughnessMapTransform)),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)}function p(g,d,y){g.ior.value=d.ior,d.diffuseRoughness>0&&(g.diffuseRoughness.value=d.diffuseRoughness,d.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=d.diffuseRoughnessMap,e(d.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),d.sheen>0&&(g.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),g.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(g.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,g.sheenColorMapTransform)),d.sheenRoughnessMap&&(g.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,g.sheenRoughnessMapTransform))),d.clearcoat>0&&(g.clearcoat.value=d.clearcoat,g.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(g.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,g.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(g.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Un&&g.clearcoatNormalScale.value.negate())),d.dispersion>0&&(g.dispersion.value=d.dispersion),d.retroreflectivity>0&&(g.retroreflectivity.value=d.retroreflectivity),d.iridescence>0&&(g.iridescence.value=d.iridescence,g.iridescenceIOR.value=d.iridescenceIOR,g.iridescenceThicknessMinimum.value=d.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=d.iridescenceThicknessMaximum,d.iridescenceMap&&(g.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,g.iridescenceMapTransform)),d.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),d.transmission>0&&(g.transmission.value=d.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),d.transmissionMap&&(g.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,g.transmissionMapTransform)),g.thickness.value=d.thickness,d.thicknessMap&&(g.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=d.attenuationDistance,g.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(g.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(g.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=d.specularIntensity,g.specularColor.value.copy(d.specularColor),d.specularColorMap&&(g.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,g.specularColorMapTransform)),d.specularIntensityMap&&(g.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,d){d.matcap&&(g.matcap.value=d.matcap)}function x(g,d){let y=t.get(d).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function IM(n,t,e,i){let s={},r={};function o(y,P){let S=P.program;i.uniformBlockBinding(y,S,s[y.id])}function a(y,P){let S=s[y.id];S===void 0&&(m(y),S=l(y),s[y.id]=S,y.addEventListener("dispose",g));let R=P.program;i.updateUBOMapping(y,R);let M=t.render.frame;r[y.id]!==M&&(c(y),r[y.id]=M)}function l(y){let P=n.createBuffer(),S=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,P),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),P}function c(y){let P=s[y.id],S=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,P);for(let M=0,_=S.length;M<_;M++){let b=S[M];if(Array.isArray(b))for(let D=0,A=b.length;D<A;D++)u(b[D],M,D,R);else u(b,M,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,P,S,R){if(h(y,P,S,R)===!0){let M=y.__offset,_=y.value;if(Array.isArray(_)){let b=0;for(let D=0;D<_.length;D++){let A=_[D],E=x(A,!0);f(A,y.__data,b),b+=E.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,y.__data)}}function f(y,P,S){typeof y=="number"||typeof y=="boolean"?P[S]=y:y.isMatrix3?(P[S]=y.elements[0],P[S+1]=y.elements[1],P[S+2]=y.elements[2],P[S+3]=0,P[S+4]=y.elements[3],P[S+5]=y.elements[4],P[S+6]=y.elements[5],P[S+7]=0,P[S+8]=y.elements[6],P[S+9]=y.elements[7],P[S+10]=y.elements[8],P[S+11]=0):ArrayBuffer.isView(y)?P.set(y.subarray(0,P.length-S),S):y.toArray(P,S)}function h(y,P,S,R){let M=y.value,_=P+"_"+S;if(Array.isArray(M)){R[_]===void 0&&(R[_]=[]);let b=R[_],D=!1;for(let A=0;A<M.length;A++)p(M[A],b,A)===!0&&(D=!0);return D}return p(M,R,_)}function p(y,P,S){if(P[S]===void 0)return typeof y=="number"||typeof y=="boolean"?P[S]=y:ArrayBuffer.isView(y)?P[S]=y.slice():P[S]=y.clone(),!0;{let R=P[S];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return P[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function m(y){let P=y.uniforms,S=0,R=16;for(let _=0,b=P.length;_<b;_++){let D=Array.isArray(P[_])?P[_]:[P[_]];for(let A=0,E=D.length;A<E;A++){let N=D[A],F=Array.isArray(N.value)?N.value:[N.value],I=Array.isArray(P[_])||Array.isArray(N.value),B=S;for(let z=0,ht=F.length;z<ht;z++){let Y=F[z],tt=x(Y,I),rt=S%R,Q=rt%tt.boundary,st=rt+Q;S+=Q,st!==0&&R-st<tt.storage&&(S+=R-st),z===0&&(B=S),S+=tt.storage}let X=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new X((S-B)/Float32Array.BYTES_PER_ELEMENT),N.__offset=B}}let M=S%R;return M>0&&(S+=R-M),y.__size=S,y.__cache={},this}function x(y,P){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?Jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):Jt("WebGLRenderer: Unsupported uniform value type.",y),P===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(y){let P=y.target;P.removeEventListener("dispose",g),n.deleteBuffer(s[P.id]),delete s[P.id],delete r[P.id]}function d(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:d}}var LM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ki=null;function DM(){return Ki===null&&(Ki=new so(LM,16,16,Xs,Pi),Ki.name="DFG_LUT",Ki.minFilter=Dn,Ki.magFilter=Dn,Ki.wrapS=Xi,Ki.wrapT=Xi,Ki.generateMipmaps=!1,Ki.needsUpdate=!0),Ki}var Gc=class{constructor(t={}){let{canvas:e=Cp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:p=jn}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=p,g=new Set([oc,rc,sc]),d=new Set([jn,Ci,uo,ur,nc,ic]),y=new Uint32Array(4),P=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,M=null,_=[],b=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let A=this,E=!1,N=null,F=null,I=null,B=null;this._outputColorSpace=kn;let X=0,z=0,ht=null,Y=-1,tt=null,rt=new $e,Q=new $e,st=null,$=new re(0),ft=0,it=e.width,gt=e.height,mt=1,W=null,nt=null,lt=new $e(0,0,it,gt),Dt=new $e(0,0,it,gt),Ot=!1,Xt=new Bs,he=new Dl,ye=!1,ze=!1,ve=new we,Ke=new G,me=new $e,sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ne=!1;function je(){return ht===null?mt:1}let V=i;function It(C,H){return e.getContext(C,H)}let Kt,oe,Tt,Ue,Wt,Zt,L,w,Z,xt,dt,Mt,bt,ot,ct,vt,k,ut,at,At,St,Et,qt;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Vt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Pt,!1),V===null){let H="webgl2";if(V=It(H,C),V===null)throw It(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(C){throw e.removeEventListener("webglcontextlost",Vt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Pt,!1),Qt("WebGLRenderer: "+C.message),C}function te(){Kt=new Wv(V),Kt.init(),St=new TM(V,Kt),oe=new Dv(V,Kt,t,St),Tt=new wM(V,Kt),oe.reversedDepthBuffer&&h&&Tt.buffers.depth.setReversed(!0),F=V.createFramebuffer(),I=V.createFramebuffer(),B=V.createFramebuffer(),Ue=new Yv(V),Wt=new hM,Zt=new EM(V,Kt,Tt,Wt,oe,St,Ue),L=new Hv(A),w=new Z_(V),Et=new Iv(V,w),Z=new Xv(V,w,Ue,Et),xt=new Zv(V,Z,w,Et,Ue),ut=new $v(V,oe,Zt),ct=new Nv(Wt),dt=new cM(A,L,Kt,oe,Et,ct),Mt=new PM(A,Wt),bt=new fM,ot=new xM(Kt),k=new Pv(A,L,Tt,xt,m,l),vt=new bM(A,xt,oe),qt=new IM(V,Ue,oe,Tt),at=new Lv(V,Kt,Ue),At=new qv(V,Kt,Ue),Ue.programs=dt.programs,A.capabilities=oe,A.extensions=Kt,A.properties=Wt,A.renderLists=bt,A.shadowMap=vt,A.state=Tt,A.info=Ue}x!==jn&&(D=new Kv(x,e.width,e.height,a,s,r));let _t=new lf(A,V);this.xr=_t,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let C=Kt.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Kt.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(C){C!==void 0&&(mt=C,this.setSize(it,gt,!1))},this.getSize=function(C){return C.set(it,gt)},this.setSize=function(C,H,et=!0){if(_t.isPresenting){Jt("WebGLRenderer: Can't change size while VR device is presenting.");return}it=C,gt=H,e.width=Math.floor(C*mt),e.height=Math.floor(H*mt),et===!0&&(e.style.width=C+"px",e.style.height=H+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,C,H)},this.getDrawingBufferSize=function(C){return C.set(it*mt,gt*mt).floor()},this.setDrawingBufferSize=function(C,H,et){it=C,gt=H,mt=et,e.width=Math.floor(C*et),e.height=Math.floor(H*et),this.setViewport(0,0,C,H)},this.setEffects=function(C){if(x===jn){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let H=0;H<C.length;H++)if(C[H].isOutputPass===!0){Jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(rt)},this.getViewport=function(C){return C.copy(lt)},this.setViewport=function(C,H,et,J){C.isVector4?lt.set(C.x,C.y,C.z,C.w):lt.set(C,H,et,J),Tt.viewport(rt.copy(lt).multiplyScalar(je()).round())},this.getScissor=function(C){return C.copy(Dt)},this.setScissor=function(C,H,et,J){C.isVector4?Dt.set(C.x,C.y,C.z,C.w):Dt.set(C,H,et,J),Tt.scissor(Q.copy(Dt).multiplyScalar(je()).round())},this.getScissorTest=function(){return Ot},this.setScissorTest=function(C){Tt.setScissorTest(Ot=C)},this.setOpaqueSort=function(C){W=C},this.setTransparentSort=function(C){nt=C},this.getClearColor=function(C){return C.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(C=!0,H=!0,et=!0){let J=0;if(C){let K=!1;if(ht!==null){let Ct=ht.texture.format;K=g.has(Ct)}if(K){let Ct=ht.texture.type,Lt=d.has(Ct),Rt=k.getClearColor(),Nt=k.getClearAlpha(),Ht=Rt.r,ne=Rt.g,ue=Rt.b;Lt?(y[0]=Ht,y[1]=ne,y[2]=ue,y[3]=Nt,V.clearBufferuiv(V.COLOR,0,y)):(P[0]=Ht,P[1]=ne,P[2]=ue,P[3]=Nt,V.clearBufferiv(V.COLOR,0,P))}else J|=V.COLOR_BUFFER_BIT}H&&(J|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(J|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&V.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),N=C},this.dispose=function(){e.removeEventListener("webglcontextlost",Vt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Pt,!1),k.dispose(),bt.dispose(),ot.dispose(),Zt.dispose(),Wt.dispose(),L.dispose(),xt.dispose(),Z.dispose(),Et.dispose(),qt.dispose(),dt.dispose(),_t.dispose(),_t.removeEventListener("sessionstart",Ba),_t.removeEventListener("sessionend",Fi),ts.stop()};function Vt(C){C.preventDefault(),$o("WebGLRenderer: Context Lost."),E=!0}function ee(){$o("WebGLRenderer: Context Restored."),E=!1;let C=Ue.autoReset,H=vt.enabled,et=vt.autoUpdate,J=vt.needsUpdate,K=vt.type;te(),Ue.autoReset=C,vt.enabled=H,vt.autoUpdate=et,vt.needsUpdate=J,vt.type=K}function Pt(C){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function ae(C){let H=C.target;H.removeEventListener("dispose",ae),ke(H)}function ke(C){Gn(C),Wt.remove(C)}function Gn(C){let H=Wt.get(C).programs;H!==void 0&&(H.forEach(function(et){dt.releaseProgram(et)}),C.isShaderMaterial&&dt.releaseShaderCache(C))}this.renderBufferDirect=function(C,H,et,J,K,Ct){H===null&&(H=sn);let Lt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Rt=Ro(C,H,et,J,K);Tt.setMaterial(J,Lt);let Nt=et.index,Ht=1;if(J.wireframe===!0){if(Nt=Z.getWireframeAttribute(et),Nt===void 0)return;Ht=2}let ne=et.drawRange,ue=et.attributes.position,Gt=ne.start*Ht,fe=(ne.start+ne.count)*Ht;Ct!==null&&(Gt=Math.max(Gt,Ct.start*Ht),fe=Math.min(fe,(Ct.start+Ct.count)*Ht)),Nt!==null?(Gt=Math.max(Gt,0),fe=Math.min(fe,Nt.count)):ue!=null&&(Gt=Math.max(Gt,0),fe=Math.min(fe,ue.count));let Je=fe-Gt;if(Je<0||Je===1/0)return;Et.setup(K,J,Rt,et,Nt);let Pe,Ie=at;if(Nt!==null&&(Pe=w.get(Nt),Ie=At,Ie.setIndex(Pe)),K.isMesh)J.wireframe===!0?(Tt.setLineWidth(J.wireframeLinewidth*je()),Ie.setMode(V.LINES)):Ie.setMode(V.TRIANGLES);else if(K.isLine){let xn=J.linewidth;xn===void 0&&(xn=1),Tt.setLineWidth(xn*je()),K.isLineSegments?Ie.setMode(V.LINES):K.isLineLoop?Ie.setMode(V.LINE_LOOP):Ie.setMode(V.LINE_STRIP)}else K.isPoints?Ie.setMode(V.POINTS):K.isSprite&&Ie.setMode(V.TRIANGLES);if(K.isBatchedMesh)if(Kt.get("WEBGL_multi_draw"))Ie.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let xn=K._multiDrawStarts,zt=K._multiDrawCounts,ln=K._multiDrawCount,ge=Nt?w.get(Nt).bytesPerElement:1,ns=Wt.get(J).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)ns.setValue(V,"_gl_DrawID",cn),Ie.render(xn[cn]/ge,zt[cn])}else if(K.isInstancedMesh)Ie.renderInstances(Gt,Je,K.count);else if(et.isInstancedBufferGeometry){let xn=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,zt=Math.min(et.instanceCount,xn);Ie.renderInstances(Gt,Je,zt)}else Ie.render(Gt,Je)};function To(C,H,et,J){N!==null&&C.isNodeMaterial&&N.setObject(J,C),ye===!0&&ct.setState(C,et,!1),C.transparent===!0&&C.side===gi&&C.forceSinglePass===!1?(C.side=Un,C.needsUpdate=!0,Oi(C,H,J),C.side=Ws,C.needsUpdate=!0,Oi(C,H,J),C.side=gi):Oi(C,H,J)}this.compile=function(C,H,et=null){et===null&&(et=C),N!==null&&N.renderStart(C,H,et),M=ot.get(et),M.init(H),b.push(M),et.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),C!==et&&C.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),M.setupLights(),N!==null&&N.updateLights(M.state.lightsArray),ze=this.localClippingEnabled,ye=ct.init(this.clippingPlanes,ze),ye===!0&&ct.setGlobalState(this.clippingPlanes,H),N!==null&&vt.render(M.state.shadowsArray,et,H);let J=new Set;return C.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ct=K.material;if(Ct)if(Array.isArray(Ct))for(let Lt=0;Lt<Ct.length;Lt++){let Rt=Ct[Lt];To(Rt,et,H,K),J.add(Rt)}else To(Ct,et,H,K),J.add(Ct)}),M=b.pop(),N!==null&&N.renderEnd(),J},this.compileAsync=function(C,H,et=null){let J=this.compile(C,H,et);return new Promise(K=>{function Ct(){if(J.forEach(function(Lt){let Nt=Wt.get(Lt).currentProgram;(Nt===void 0||Nt.isReady())&&J.delete(Lt)}),J.size===0){K(C);return}setTimeout(Ct,10)}Kt.get("KHR_parallel_shader_compile")!==null?Ct():setTimeout(Ct,10)})};let vr=null;function Rh(C){vr&&vr(C)}function Ba(){ts.stop()}function Fi(){ts.start()}let ts=new sm;ts.setAnimationLoop(Rh),typeof self<"u"&&ts.setContext(self),this.setAnimationLoop=function(C){vr=C,_t.setAnimationLoop(C),C===null?ts.stop():ts.start()},_t.addEventListener("sessionstart",Ba),_t.addEventListener("sessionend",Fi),this.render=function(C,H){if(H!==void 0&&H.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(E===!0)return;N!==null&&N.renderStart(C,H);let et=_t.enabled===!0&&_t.isPresenting===!0,J=D!==null&&(ht===null||et)&&D.begin(A,ht);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),_t.enabled===!0&&_t.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(_t.cameraAutoUpdate===!0&&_t.updateCamera(H),H=_t.getCamera()),C.isScene===!0&&C.onBeforeRender(A,C,H,ht),M=ot.get(C,b.length),M.init(H),M.state.textureUnits=Zt.getTextureUnits(),b.push(M),ve.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?he.setFromArrayCamera(H):Xt.setFromProjectionMatrix(ve,pi,H.reversedDepth),ze=this.localClippingEnabled,ye=ct.init(this.clippingPlanes,ze),R=bt.get(C,_.length),R.init(),_.push(R),this.info.render.frame++,_t.enabled===!0&&_t.isPresenting===!0){let Lt=A.xr.getDepthSensingMesh();Lt!==null&&es(Lt,H,-1/0,A.sortObjects)}es(C,H,0,A.sortObjects),R.finish(),N!==null&&N.updateLights(M.state.lightsArray),A.sortObjects===!0&&R.sort(W,nt),Ne=_t.enabled===!1||_t.isPresenting===!1||_t.hasDepthSensing()===!1,Ne&&k.addToRenderList(R,C),this.info.autoReset===!0&&this.info.reset(),ye===!0&&ct.beginShadows();let K=M.state.shadowsArray;if(vt.render(K,C,H),ye===!0&&ct.endShadows(),(J&&D.hasRenderPass())===!1){let Lt=R.opaque,Rt=R.transmissive;if(M.setupLights(),H.isArrayCamera){let Nt=H.cameras;if(Rt.length>0)for(let Ht=0,ne=Nt.length;Ht<ne;Ht++){let ue=Nt[Ht];vi(Lt,Rt,C,ue)}Ne&&k.render(C);for(let Ht=0,ne=Nt.length;Ht<ne;Ht++){let ue=Nt[Ht];Ao(R,C,ue,ue.viewport)}}else Rt.length>0&&vi(Lt,Rt,C,H),Ne&&k.render(C),Ao(R,C,H)}ht!==null&&z===0&&(Zt.updateMultisampleRenderTarget(ht),Zt.updateRenderTargetMipmap(ht)),J&&D.end(A),C.isScene===!0&&C.onAfterRender(A,C,H),Et.resetDefaultState(),Y=-1,tt=null,b.pop(),b.length>0?(M=b[b.length-1],Zt.setTextureUnits(M.state.textureUnits),ye===!0&&ct.setGlobalState(A.clippingPlanes,M.state.camera)):M=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,N!==null&&N.renderEnd()};function es(C,H,et,J){if(C.visible===!1)return;if(C.layers.test(H.layers)){if(C.isGroup)et=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(H);else if(C.isLight)M.pushLight(C),C.castShadow&&M.pushShadow(C);else if(C.isSprite){let Lt=H.isArrayCamera?he:Xt;if(!C.frustumCulled||C.intersectsFrustum(Lt)){J&&me.setFromMatrixPosition(C.matrixWorld).applyMatrix4(ve);let Rt=xt.update(C),Nt=C.material;Nt.visible&&R.push(C,Rt,Nt,et,me.z,null,H)}}else if(C.isMesh||C.isLine||C.isPoints){let Lt=H.isArrayCamera?he:Xt;if(!C.frustumCulled||C.intersectsFrustum(Lt)){let Rt=xt.update(C),Nt=C.material;if(J&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),me.copy(C.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),me.copy(Rt.boundingSphere.center)),me.applyMatrix4(C.matrixWorld).applyMatrix4(ve)),Array.isArray(Nt)){let Ht=Rt.groups;for(let ne=0,ue=Ht.length;ne<ue;ne++){let Gt=Ht[ne],fe=Nt[Gt.materialIndex];fe&&fe.visible&&R.push(C,Rt,fe,et,me.z,Gt,H)}}else Nt.visible&&R.push(C,Rt,Nt,et,me.z,null,H)}}}let Ct=C.children;for(let Lt=0,Rt=Ct.length;Lt<Rt;Lt++)es(Ct[Lt],H,et,J)}function Ao(C,H,et,J){let{opaque:K,transmissive:Ct,transparent:Lt}=C;M.setupLightsView(et),ye===!0&&ct.setGlobalState(A.clippingPlanes,et),J&&Tt.viewport(rt.copy(J)),K.length>0&&Qe(K,H,et),Ct.length>0&&Qe(Ct,H,et),Lt.length>0&&Qe(Lt,H,et),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function vi(C,H,et,J){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[J.id]===void 0){let Gt=Kt.has("EXT_color_buffer_half_float")||Kt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[J.id]=new oi(1,1,{generateMipmaps:!0,type:Gt?Pi:jn,minFilter:_s,samples:Math.max(4,oe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Ct=M.state.transmissionRenderTarget[J.id],Lt=J.viewport||rt;Ct.setSize(Lt.z*A.transmissionResolutionScale,Lt.w*A.transmissionResolutionScale);let Rt=A.getRenderTarget(),Nt=A.getActiveCubeFace(),Ht=A.getActiveMipmapLevel();A.setRenderTarget(Ct),A.getClearColor($),ft=A.getClearAlpha(),ft<1&&A.setClearColor(16777215,.5),A.clear(),Ne&&k.render(et);let ne=A.toneMapping;A.toneMapping=Ji;let ue=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),M.setupLightsView(J),ye===!0&&ct.setGlobalState(A.clippingPlanes,J),Qe(C,et,J),Zt.updateMultisampleRenderTarget(Ct),Zt.updateRenderTargetMipmap(Ct),Kt.has("WEBGL_multisampled_render_to_texture")===!1){let Gt=!1;for(let fe=0,Je=H.length;fe<Je;fe++){let Pe=H[fe],{object:Ie,geometry:xn,material:zt,group:ln}=Pe;if(zt.side===gi&&Ie.layers.test(J.layers)){let ge=zt.side;zt.side=Un,zt.needsUpdate=!0,rn(Ie,et,J,xn,zt,ln),zt.side=ge,zt.needsUpdate=!0,Gt=!0}}Gt===!0&&(Zt.updateMultisampleRenderTarget(Ct),Zt.updateRenderTargetMipmap(Ct))}A.setRenderTarget(Rt,Nt,Ht),A.setClearColor($,ft),ue!==void 0&&(J.viewport=ue),A.toneMapping=ne}function Qe(C,H,et){let J=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Ct=C.length;K<Ct;K++){let Lt=C[K],{object:Rt,geometry:Nt,group:Ht}=Lt,ne=Lt.material;ne.allowOverride===!0&&J!==null&&(ne=J),Rt.layers.test(et.layers)&&rn(Rt,H,et,Nt,ne,Ht)}}function rn(C,H,et,J,K,Ct){N!==null&&K.isNodeMaterial&&N.setObject(C,K),C.onBeforeRender(A,H,et,J,K,Ct),C.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),K.onBeforeRender(A,H,et,J,C,Ct),K.transparent===!0&&K.side===gi&&K.forceSinglePass===!1?(K.side=Un,K.needsUpdate=!0,A.renderBufferDirect(et,H,J,K,C,Ct),K.side=Ws,K.needsUpdate=!0,A.renderBufferDirect(et,H,J,K,C,Ct),K.side=gi):A.renderBufferDirect(et,H,J,K,C,Ct),C.onAfterRender(A,H,et,J,K,Ct)}function on(C){let H=0;for(let et of C)et.texture!==null&&H++;return H}function Oi(C,H,et){H.isScene!==!0&&(H=sn);let J=Wt.get(C),K=M.state.lights,Ct=M.state.shadowsArray,Lt=K.state.version,Rt=dt.getParameters(C,K.state,Ct,H,et,M.state.lightProbeGridArray),Nt=dt.getProgramCacheKey(Rt),Ht=J.programs;J.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?H.environment:null,J.fog=H.fog;let ne=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;J.envMap=L.get(C.envMap||J.environment,ne),J.envMapRotation=J.environment!==null&&C.envMap===null?H.environmentRotation:C.envMapRotation,Ht===void 0&&(C.addEventListener("dispose",ae),Ht=new Map,J.programs=Ht,J.programVariants=new Map);let ue=Ht.get(Nt);if(ue!==void 0){if(J.currentProgram===ue&&J.lightsStateVersion===Lt)return Co(C,Rt),ue}else Rt.uniforms=dt.getUniforms(C),N!==null&&C.isNodeMaterial&&N.build(C,et,Rt),C.onBeforeCompile(Rt,A),ue=dt.acquireProgram(Rt,Nt),Ht.set(Nt,ue),J.uniforms=Rt.uniforms;let Gt=J.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Gt.clippingPlanes=ct.uniform),Co(C,Rt),J.needsLights=Ts(C),J.lightsStateVersion=Lt,J.needsLights&&(Gt.ambientLightColor.value=K.state.ambient,Gt.lightProbe.value=K.state.probe,Gt.sunLights.value=K.state.sun,Gt.sunLightShadows.value=K.state.sunShadow,Gt.directionalLights.value=K.state.directional,Gt.directionalLightShadows.value=K.state.directionalShadow,Gt.spotLights.value=K.state.spot,Gt.spotLightShadows.value=K.state.spotShadow,Gt.rectAreaLights.value=K.state.rectArea,Gt.ltc_1.value=K.state.rectAreaLTC1,Gt.ltc_2.value=K.state.rectAreaLTC2,Gt.pointLights.value=K.state.point,Gt.pointLightShadows.value=K.state.pointShadow,Gt.hemisphereLights.value=K.state.hemi,Gt.sunShadowMatrix.value=K.state.sunShadowMatrix,Gt.sunShadowCascade.value=K.state.sunShadowCascade,Gt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Gt.spotLightMatrix.value=K.state.spotLightMatrix,Gt.spotLightMap.value=K.state.spotLightMap,Gt.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=on(M.state.lightProbeGridArray),J.currentProgram=ue,J.uniformsList=null,ue}function ti(C,H,et,J,K){let Ct=Wt.get(C),Lt=Ct.currentProgram.id+","+J+","+K,Rt=Ct.programVariants.get(Lt);return Rt===void 0?(Rt=Oi(C,H,et),Ct.programVariants.set(Lt,Rt)):(Ct.currentProgram=Rt,Ct.uniformsList=null,Ct.outputColorSpace=J,Ct.toneMapping=K),Rt}function Es(C){if(C.uniformsList===null){let H=C.currentProgram.getUniforms();C.uniformsList=fo.seqWithValue(H.seq,C.uniforms)}return C.uniformsList}function Co(C,H){let et=Wt.get(C);et.outputColorSpace=H.outputColorSpace,et.batching=H.batching,et.batchingColor=H.batchingColor,et.instancing=H.instancing,et.instancingColor=H.instancingColor,et.instancingMorph=H.instancingMorph,et.skinning=H.skinning,et.morphTargets=H.morphTargets,et.morphNormals=H.morphNormals,et.morphColors=H.morphColors,et.morphTargetsCount=H.morphTargetsCount,et.numClippingPlanes=H.numClippingPlanes,et.numIntersection=H.numClipIntersection,et.vertexAlphas=H.vertexAlphas,et.vertexTangents=H.vertexTangents,et.toneMapping=H.toneMapping}function Ro(C,H,et,J,K){H.isScene!==!0&&(H=sn),Zt.resetTextureUnits();let Ct=H.fog,Lt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?H.environment:null,Rt=ht===null?A.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:_e.workingColorSpace,Nt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Ht=L.get(J.envMap||Lt,Nt),ne=J.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,ue=!!et.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Gt=!!et.morphAttributes.position,fe=!!et.morphAttributes.normal,Je=!!et.morphAttributes.color,Pe=Ji;J.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Pe=A.toneMapping);let Ie=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,xn=Ie!==void 0?Ie.length:0,zt=Wt.get(J),ln=M.state.lights;if(ye===!0&&(ze===!0||C!==tt)){let Le=C===tt&&J.id===Y;ct.setState(J,C,Le)}let ge=!1,ns=!1;J.version===zt.__version?zt.needsLights&&zt.lightsStateVersion!==ln.state.version||K.isBatchedMesh&&zt.batching===!1||!K.isBatchedMesh&&zt.batching===!0||K.isBatchedMesh&&zt.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&zt.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&zt.instancing===!1||!K.isInstancedMesh&&zt.instancing===!0||K.isSkinnedMesh&&zt.skinning===!1||!K.isSkinnedMesh&&zt.skinning===!0||K.isInstancedMesh&&zt.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&zt.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&zt.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&zt.instancingMorph===!1&&K.morphTexture!==null||zt.envMap!==Ht||J.fog===!0&&zt.fog!==Ct||zt.numClippingPlanes!==void 0&&(zt.numClippingPlanes!==ct.numPlanes||zt.numIntersection!==ct.numIntersection)||zt.vertexAlphas!==ne||zt.vertexTangents!==ue||zt.morphTargets!==Gt||zt.morphNormals!==fe||zt.morphColors!==Je||zt.morphTargetsCount!==xn||zt.numLightProbeGrids!==on(M.state.lightProbeGridArray)?ge=!0:(zt.outputColorSpace!==Rt||zt.toneMapping!==Pe)&&(ns=!0):(ge=!0,zt.__version=J.version);let cn=zt.currentProgram;(ge===!0||ns===!0)&&(cn=ns===!0?ti(J,H,K,Rt,Pe):Oi(J,H,K),N&&J.isNodeMaterial&&N.onUpdateProgram(J,cn,zt));let br=!1,Bi=!1,is=!1,le=cn.getUniforms(),tn=zt.uniforms;if(Tt.useProgram(cn.program)&&(br=!0,Bi=!0,is=!0),J.id!==Y&&(Y=J.id,Bi=!0),br||tt!==C){Tt.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),le.setValue(V,"projectionMatrix",C.projectionMatrix),le.setValue(V,"viewMatrix",C.matrixWorldInverse);let hn=le.map.cameraPosition;hn!==void 0&&hn.setValue(V,Ke.setFromMatrixPosition(C.matrixWorld)),oe.logarithmicDepthBuffer&&le.setValue(V,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&le.setValue(V,"isOrthographic",C.isOrthographicCamera===!0),tt!==C&&(tt=C,Bi=!0,is=!0)}if(zt.needsLights&&(ln.state.sunShadowMap.length>0&&le.setValue(V,"sunShadowMap",ln.state.sunShadowMap,Zt),ln.state.directionalShadowMap.length>0&&le.setValue(V,"directionalShadowMap",ln.state.directionalShadowMap,Zt),ln.state.spotShadowMap.length>0&&le.setValue(V,"spotShadowMap",ln.state.spotShadowMap,Zt),ln.state.pointShadowMap.length>0&&le.setValue(V,"pointShadowMap",ln.state.pointShadowMap,Zt)),K.isSkinnedMesh){le.setOptional(V,K,"bindMatrix"),le.setOptional(V,K,"bindMatrixInverse");let Le=K.skeleton;Le&&(Le.boneTexture===null&&Le.computeBoneTexture(),le.setValue(V,"boneTexture",Le.boneTexture,Zt))}K.isBatchedMesh&&(le.setOptional(V,K,"batchingTexture"),le.setValue(V,"batchingTexture",K._matricesTexture,Zt),le.setOptional(V,K,"batchingIdTexture"),le.setValue(V,"batchingIdTexture",K._indirectTexture,Zt),le.setOptional(V,K,"batchingColorTexture"),K._colorsTexture!==null&&le.setValue(V,"batchingColorTexture",K._colorsTexture,Zt));let Hn=et.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&ut.update(K,et,cn),(Bi||zt.receiveShadow!==K.receiveShadow)&&(zt.receiveShadow=K.receiveShadow,le.setValue(V,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&H.environment!==null&&(tn.envMapIntensity.value=H.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=DM()),Bi){if(le.setValue(V,"toneMappingExposure",A.toneMappingExposure),zt.needsLights&&Sr(tn,is),Ct&&J.fog===!0&&Mt.refreshFogUniforms(tn,Ct),Mt.refreshMaterialUniforms(tn,J,mt,gt,M.state.transmissionRenderTarget[C.id]),zt.needsLights&&zt.numLightProbeGrids>0){let Le=S,hn=0;for(let On of M.state.lightProbeGridArray)On.texture!==null&&(Le.textures[hn]=On.texture,Le.min[hn]=On.boundingBox.min,Le.max[hn]=On.boundingBox.max,Le.resolution[hn]=On.resolution,hn++);for(let On in Le)Le[On].length=hn;tn.probesSH.value=Le.textures,tn.probesMin.value=Le.min,tn.probesMax.value=Le.max,tn.probesResolution.value=Le.resolution}fo.upload(V,Es(zt),tn,Zt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(fo.upload(V,Es(zt),tn,Zt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&le.setValue(V,"center",K.center),le.setValue(V,"modelViewMatrix",K.modelViewMatrix),le.setValue(V,"normalMatrix",K.normalMatrix),le.setValue(V,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Le=J.uniformsGroups;for(let hn=0,On=Le.length;hn<On;hn++){let za=Le[hn];qt.update(za,cn),qt.bind(za,cn)}}return cn}function Sr(C,H){C.ambientLightColor.needsUpdate=H,C.lightProbe.needsUpdate=H,C.sunLights.needsUpdate=H,C.sunLightShadows.needsUpdate=H,C.directionalLights.needsUpdate=H,C.directionalLightShadows.needsUpdate=H,C.pointLights.needsUpdate=H,C.pointLightShadows.needsUpdate=H,C.spotLights.needsUpdate=H,C.spotLightShadows.needsUpdate=H,C.rectAreaLights.needsUpdate=H,C.hemisphereLights.needsUpdate=H}function Ts(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(C,H,et){let J=Wt.get(C);J.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Wt.get(C.texture).__webglTexture=H,Wt.get(C.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:et,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,H){let et=Wt.get(C);et.__webglFramebuffer=H,et.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(C,H=0,et=0){ht=C,X=H,z=et;let J=null,K=!1,Ct=!1;if(C){let Rt=Wt.get(C);if(Rt.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(V.FRAMEBUFFER,Rt.__webglFramebuffer),rt.copy(C.viewport),Q.copy(C.scissor),st=C.scissorTest,Tt.viewport(rt),Tt.scissor(Q),Tt.setScissorTest(st),Y=-1;return}else if(Rt.__webglFramebuffer===void 0)Zt.setupRenderTarget(C);else if(Rt.__hasExternalTextures)Zt.rebindTextures(C,Wt.get(C.texture).__webglTexture,Wt.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let ne=C.depthTexture;if(Rt.__boundDepthTexture!==ne){if(ne!==null&&Wt.has(ne)&&(C.width!==ne.image.width||C.height!==ne.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Zt.setupDepthRenderbuffer(C)}}let Nt=C.texture;(Nt.isData3DTexture||Nt.isDataArrayTexture||Nt.isCompressedArrayTexture)&&(Ct=!0);let Ht=Wt.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ht[H])?J=Ht[H][et]:J=Ht[H],K=!0):C.samples>0&&Zt.useMultisampledRTT(C)===!1?J=Wt.get(C).__webglMultisampledFramebuffer:Array.isArray(Ht)?J=Ht[et]:J=Ht,rt.copy(C.viewport),Q.copy(C.scissor),st=C.scissorTest}else rt.copy(lt).multiplyScalar(mt).floor(),Q.copy(Dt).multiplyScalar(mt).floor(),st=Ot;if(et!==0&&(J=F),Tt.bindFramebuffer(V.FRAMEBUFFER,J)&&Tt.drawBuffers(C,J),Tt.viewport(rt),Tt.scissor(Q),Tt.setScissorTest(st),K){let Rt=Wt.get(C.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+H,Rt.__webglTexture,et)}else if(Ct){let Rt=H;for(let Nt=0;Nt<C.textures.length;Nt++){let Ht=Wt.get(C.textures[Nt]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Nt,Ht.__webglTexture,et,Rt)}}else if(C!==null&&et!==0){let Rt=Wt.get(C.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Rt.__webglTexture,et)}Y=-1};function Mr(C){let H=Wt.get(C);return(H.__readFormat!==C.format||H.__readType!==C.type)&&(H.__readFormat=C.format,H.__readType=C.type,H.__formatReadable=oe.textureFormatReadable(C.format),H.__typeReadable=oe.textureTypeReadable(C.type)),H}this.readRenderTargetPixels=function(C,H,et,J,K,Ct,Lt,Rt=0){if(!(C&&C.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Nt=Wt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Lt!==void 0&&(Nt=Nt[Lt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt){Tt.bindFramebuffer(V.FRAMEBUFFER,Nt);try{let Ht=C.textures[Rt],ne=Ht.format,ue=Ht.type;C.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Rt);let Gt=Mr(Ht);if(Gt.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Gt.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=C.width-J&&et>=0&&et<=C.height-K&&V.readPixels(H,et,J,K,St.convert(ne),St.convert(ue),Ct)}finally{let Ht=ht!==null?Wt.get(ht).__webglFramebuffer:null;Tt.bindFramebuffer(V.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(C,H,et,J,K,Ct,Lt,Rt=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Nt=Wt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Lt!==void 0&&(Nt=Nt[Lt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt)if(H>=0&&H<=C.width-J&&et>=0&&et<=C.height-K){Tt.bindFramebuffer(V.FRAMEBUFFER,Nt);let Ht=C.textures[Rt],ne=Ht.format,ue=Ht.type;C.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Rt);let Gt=Mr(Ht);if(Gt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Gt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let fe=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,fe),V.bufferData(V.PIXEL_PACK_BUFFER,Ct.byteLength,V.STREAM_READ),V.readPixels(H,et,J,K,St.convert(ne),St.convert(ue),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Je=ht!==null?Wt.get(ht).__webglFramebuffer:null;Tt.bindFramebuffer(V.FRAMEBUFFER,Je);let Pe=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await Pp(V,Pe,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,fe),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Ct),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(fe),V.deleteSync(Pe),Ct}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,H=null,et=0){let J=Math.pow(2,-et),K=Math.floor(C.image.width*J),Ct=Math.floor(C.image.height*J),Lt=H!==null?H.x:0,Rt=H!==null?H.y:0;Zt.setTexture2D(C,0),V.copyTexSubImage2D(V.TEXTURE_2D,et,0,0,Lt,Rt,K,Ct),Tt.unbindTexture()},this.copyTextureToTexture=function(C,H,et=null,J=null,K=0,Ct=0){let Lt,Rt,Nt,Ht,ne,ue,Gt,fe,Je,Pe=C.isCompressedTexture?C.mipmaps[Ct]:C.image;if(et!==null)Lt=et.max.x-et.min.x,Rt=et.max.y-et.min.y,Nt=et.isBox3?et.max.z-et.min.z:1,Ht=et.min.x,ne=et.min.y,ue=et.isBox3?et.min.z:0;else{let le=Math.pow(2,-K);Lt=Math.floor(Pe.width*le),Rt=Math.floor(Pe.height*le),C.isDataArrayTexture?Nt=Pe.depth:C.isData3DTexture?Nt=Math.floor(Pe.depth*le):Nt=1,Ht=0,ne=0,ue=0}J!==null?(Gt=J.x,fe=J.y,Je=J.z):(Gt=0,fe=0,Je=0);let Ie=St.convert(H.format),xn=St.convert(H.type),zt;H.isData3DTexture?(Zt.setTexture3D(H,0),zt=V.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Zt.setTexture2DArray(H,0),zt=V.TEXTURE_2D_ARRAY):(Zt.setTexture2D(H,0),zt=V.TEXTURE_2D),Tt.activeTexture(V.TEXTURE0),Tt.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,H.flipY),Tt.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Tt.pixelStorei(V.UNPACK_ALIGNMENT,H.unpackAlignment);let ln=Tt.getParameter(V.UNPACK_ROW_LENGTH),ge=Tt.getParameter(V.UNPACK_IMAGE_HEIGHT),ns=Tt.getParameter(V.UNPACK_SKIP_PIXELS),cn=Tt.getParameter(V.UNPACK_SKIP_ROWS),br=Tt.getParameter(V.UNPACK_SKIP_IMAGES);Tt.pixelStorei(V.UNPACK_ROW_LENGTH,Pe.width),Tt.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Pe.height),Tt.pixelStorei(V.UNPACK_SKIP_PIXELS,Ht),Tt.pixelStorei(V.UNPACK_SKIP_ROWS,ne),Tt.pixelStorei(V.UNPACK_SKIP_IMAGES,ue);let Bi=C.isDataArrayTexture||C.isData3DTexture,is=H.isDataArrayTexture||H.isData3DTexture;if(C.isDepthTexture){let le=Wt.get(C),tn=Wt.get(H),Hn=Wt.get(le.__renderTarget),Le=Wt.get(tn.__renderTarget);Tt.bindFramebuffer(V.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Tt.bindFramebuffer(V.DRAW_FRAMEBUFFER,Le.__webglFramebuffer);for(let hn=0;hn<Nt;hn++)Bi&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Wt.get(C).__webglTexture,K,ue+hn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Wt.get(H).__webglTexture,Ct,Je+hn)),V.blitFramebuffer(Ht,ne,Ht+Lt,ne+Rt,Gt,fe,Gt+Lt,fe+Rt,V.DEPTH_BUFFER_BIT,V.NEAREST);Tt.bindFramebuffer(V.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(K!==0||C.isRenderTargetTexture||Wt.has(C)){let le=Wt.get(C),tn=Wt.get(H);Tt.bindFramebuffer(V.READ_FRAMEBUFFER,I),Tt.bindFramebuffer(V.DRAW_FRAMEBUFFER,B);for(let Hn=0;Hn<Nt;Hn++)Bi?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,le.__webglTexture,K,ue+Hn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,le.__webglTexture,K),is?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,tn.__webglTexture,Ct,Je+Hn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,tn.__webglTexture,Ct),K!==0?V.blitFramebuffer(Ht,ne,Ht+Lt,ne+Rt,Gt,fe,Gt+Lt,fe+Rt,V.COLOR_BUFFER_BIT,V.NEAREST):is?V.copyTexSubImage3D(zt,Ct,Gt,fe,Je+Hn,Ht,ne,Lt,Rt):V.copyTexSubImage2D(zt,Ct,Gt,fe,Ht,ne,Lt,Rt);Tt.bindFramebuffer(V.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else is?C.isDataTexture||C.isData3DTexture?V.texSubImage3D(zt,Ct,Gt,fe,Je,Lt,Rt,Nt,Ie,xn,Pe.data):H.isCompressedArrayTexture?V.compressedTexSubImage3D(zt,Ct,Gt,fe,Je,Lt,Rt,Nt,Ie,Pe.data):V.texSubImage3D(zt,Ct,Gt,fe,Je,Lt,Rt,Nt,Ie,xn,Pe):C.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Ct,Gt,fe,Lt,Rt,Ie,xn,Pe.data):C.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Ct,Gt,fe,Pe.width,Pe.height,Ie,Pe.data):V.texSubImage2D(V.TEXTURE_2D,Ct,Gt,fe,Lt,Rt,Ie,xn,Pe);Tt.pixelStorei(V.UNPACK_ROW_LENGTH,ln),Tt.pixelStorei(V.UNPACK_IMAGE_HEIGHT,ge),Tt.pixelStorei(V.UNPACK_SKIP_PIXELS,ns),Tt.pixelStorei(V.UNPACK_SKIP_ROWS,cn),Tt.pixelStorei(V.UNPACK_SKIP_IMAGES,br),Ct===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&V.generateMipmap(zt),Tt.unbindTexture()},this.initRenderTarget=function(C){Wt.get(C).__webglFramebuffer===void 0&&Zt.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Zt.setTextureCube(C,0):C.isData3DTexture?Zt.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Zt.setTexture2DArray(C,0):Zt.setTexture2D(C,0),Tt.unbindTexture()},this.resetState=function(){X=0,z=0,ht=null,Tt.reset(),Et.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};var NM="http://www.w3.org/2000/svg",UM=["#b3261e","#2e7d32","#1652b8"],[gm,mm,Xc,cf]=[300,62,5,4],FM=32768;function _i(n,t,e,i){let s=document.createElementNS(NM,t);for(let[r,o]of Object.entries(e))s.setAttribute(r,o);return i!==void 0&&(s.textContent=i),n.append(s),s}function qc(n,t){let e=(gm-mm)/2;return mm+e+Math.sign(n)*e*Math.asinh(Math.abs(n)/t)/Math.asinh(FM/t)}function _m(n,t){n.replaceChildren();let e=3*Xc+cf,i=t.length*e+cf+20;n.setAttribute("viewBox",`0 0 ${gm} ${i}`);let s=Math.min(...t[0].noise);for(let r of[-1e4,-1e3,-100,0,100,1e3,1e4]){let o=qc(r,s);_i(n,"line",{x1:o,x2:o,y1:0,y2:i-18,stroke:r?"#e2e2dc":"#555"});let a=Math.abs(r)>=1e3?`${r/1e3}k`:`${r}`;_i(n,"text",{x:o,y:i-6,"font-size":9,"text-anchor":"middle",fill:"#555"},a.replace("-","\u2212"))}t.forEach(({face:r,counts:o,live:a,noise:l,number:c},u)=>{let f=u*e+cf;_i(n,"text",{x:0,y:f+12,"font-size":10,fill:"#333"},`F${r}-S${c}`),o.forEach((h,p)=>{if(!a[p])return;let[m,x,g]=[qc(0,s),qc(l[p],s),qc(h,s)],d=f+p*Xc+1;_i(n,"rect",{x:2*m-x,width:2*(x-m),y:d,height:Xc-1,fill:"#d9d9d2"});let y={x:Math.min(m,g),width:Math.abs(g-m),y:d,height:Xc-1.5,fill:UM[p]};_i(n,"rect",{...y,opacity:Math.abs(h)<l[p]?.35:1})})})}function xm(n,t){n.replaceChildren(...t.map(({face:e,number:i,counts:s,live:r})=>{let o=document.createElement("tr");return[e,i,...s.map((l,c)=>r[c]?Math.round(l):"\u2013")].forEach(l=>o.insertCell().append(String(l))),o}))}var Yc=["440154","482475","414487","355f8d","2a788e","21918c","22a884","44bf70","7ad151","bddf26","fde725"].map(n=>new re(`#${n}`));function OM(n,t){let e=Math.min(.9999,Math.max(0,n))*(Yc.length-1);return t.lerpColors(Yc[Math.floor(e)],Yc[Math.floor(e)+1],e%1)}function BM({content:n,arrays:t}){let e=Kn(t.silicone_normals),i=new Int8Array(e.length/3).fill(-1),s=new Float32Array(i.length).fill(-2),{link_vertex:r,link_source:o}=t;return r.data.forEach((a,l)=>{let c=zM(n,o.data[l]),u=n.faces[c].normal,f=u[0]*e[3*a]+u[1]*e[3*a+1]+u[2]*e[3*a+2];f>Math.max(s[a],.3)&&([i[a],s[a]]=[c,f])}),i}function zM(n,t){let e=0;for(let i=t;i>=n.face_vertices[e];e++)i-=n.face_vertices[e];return e}function Aa(n,t,e,i){let[s,r,o]=[t-n.centre_mm[0],e-n.centre_mm[1],i-n.centre_mm[2]];return[n.x,n.y].map((a,l)=>ym(n.sections?.[l],"plane_mm","length_mm",s*a[0]+r*a[1]+o*a[2]))}function hf(n,t){return t.map((e,i)=>ym(n.sections?.[i],"length_mm","plane_mm",e))}function ym(n,t,e,i){if(!n)return i;let[s,r]=[n[t],n[e]],o=s.findIndex(l=>l>i),a=Math.max(1,o<0?s.length-1:o);return r[a-1]+(i-s[a-1])*(r[a]-r[a-1])/(s[a]-s[a-1])}function Ze(n){if(!Number.isFinite(n))return"\u2013";let t=Math.abs(n);return t>=1e4||t<.001&&t>0?n.toExponential(1):n.toPrecision(3)}function kM({content:n,arrays:t},e){let i=Kn(t.silicone_mm),s=new Float32Array(i.length).fill(-1),r=l=>l.length>1?l[1]-l[0]:1,{x_mm:o,y_mm:a}=n.grid;return e.forEach((l,c)=>{if(l<0)return;let[u,f]=Aa(n.faces[l],...i.subarray(3*c,3*c+3));s.set([(u-o[0])/r(o),(f-a[0])/r(a),l],3*c)}),s}var VM=`attribute vec3 chart; varying vec4 onFace;
`,GM=`varying vec4 onFace; uniform sampler2D score; uniform vec3 grid; uniform float mapped;
vec3 mapColour(vec3 plain) {
  if (mapped < 0.5) return plain;
  float face = floor(onFace.z + 0.5);
  vec2 last = grid.xy - 1.0;
  bool judged = face >= 0.0 && abs(onFace.z - face) < 0.01 && abs(onFace.w - onFace.z * onFace.z) < 0.01
    && all(greaterThan(onFace.xy, vec2(-0.5))) && all(lessThan(onFace.xy, last + 0.5));
  vec2 at = clamp(onFace.xy, vec2(0.0), last) + 0.5;
  vec4 found = texture2D(score, vec2(at.x, face * grid.y + at.y) / vec2(grid.x, grid.y * grid.z));
  return judged && found.a > 0.5 ? found.rgb / found.a : vec3(0.58);
}
`;function HM(n,t){n.onBeforeCompile=e=>{Object.assign(e.uniforms,t),e.vertexShader=VM+e.vertexShader.replace("#include <begin_vertex>",`#include <begin_vertex>
onFace = vec4(chart, chart.z * chart.z);`),e.fragmentShader=GM+e.fragmentShader.replace("#include <color_fragment>","diffuseColor.rgb = mapColour(diffuseColor.rgb);")},n.needsUpdate=!0}function $c(n,t,e){let{content:i,arrays:s}=n,r=BM(n),[o,a,l]=[i.grid.x_mm.length,i.grid.y_mm.length,i.faces.length],c=o*a,u=new so(new Uint8Array(4*c*l),o,a*l);u.magFilter=u.minFilter=Dn,u.colorSpace=kn;let f={score:{value:u},grid:{value:new G(o,a,l)},mapped:{value:0}};t.silicone.front.geometry.setAttribute("chart",new Ln(kM(n,r),3)),HM(t.silicone.front.material,f);let h=null,p={};function m(S){if(p[S.stem])return p[S.stem];let R=Array.from(s[`map_${S.stem}`].data).filter(M=>Number.isFinite(M)&&(!S.log||M>0));return[Math.min(...R),Math.max(...R)]}function x(S){let R=m(S),[M,_]=S.log?R.map(Math.log):R,b=A=>((S.log?Math.log(A):A)-M)/(_-M||1);return{share:A=>S.weak==="high"?1-b(A):b(A),at:A=>{let E=M+A*(_-M);return S.log?Math.exp(E):E}}}function g(S){return h=i.maps.find(R=>R.stem===S)??null,f.mapped.value=h?1:0,h&&d(x(h),s[`map_${S}`].data),e.redraw(),h&&{map:h,at:x(h).at}}function d(S,R){let M=new re,_={};R.forEach((b,D)=>{let[A,E]=[Math.floor(D/c),D%c],N=4*((A*a+E%a)*o+Math.floor(E/a));u.image.data.fill(0,N,N+4),Number.isFinite(b)&&(OM(S.share(b),M).getRGB(_,kn),u.image.data.set([_.r,_.g,_.b,1].map(F=>255*F),N))}),u.needsUpdate=!0}return{owner:r,show:g,valueAt:(S,R)=>h&&s[`map_${h.stem}`].data[S*c+R],shown:()=>h,endsOf:m,fix:(S,R)=>p[S]=R}}function Zc(n,t){if(n.hidden=!t,!t)return;let e=Yc.map(l=>`#${l.getHexString()}`);t.map.weak==="high"&&e.reverse(),n.querySelector(".scale").style.background=`linear-gradient(to right, ${e})`;let i=n.querySelectorAll(".ticks span");i.forEach((l,c)=>{let u=Ze(t.at(c/(i.length-1)));l.textContent!==u&&(l.textContent=u)});let{title:s,unit:r,log:o,force_n:a}=t.map;n.querySelector(".title").textContent=`${s}, ${r} at ${a} N${o?", logarithmic":""}. Dark is weak; grey: not judged.`}var WM=1e-6,[Jc,mo,Kc,jc]=[300,230,46,40];function vm(n,{objectives:t,trials:e,layouts:i},s){n.setAttribute("viewBox",`0 0 ${Jc} ${mo}`);let r=i.map((m,x)=>[...m.scores.slice(0,2),x]).filter(m=>!m.includes(null)),o=m=>Math.log(Math.max(m,WM)),a=[0,1].map(m=>{let x=[...e,...r].map(g=>o(g[m]));return[Math.min(...x),Math.max(...x)]}),l=(m,x)=>(o(m)-a[x][0])/(a[x][1]-a[x][0]||1),c=m=>Kc+8+l(m,0)*(Jc-Kc-16),u=m=>mo-jc-8-l(m,1)*(mo-jc-16),f=(m,x)=>_i(n,"text",{"font-size":9,fill:"#444",...x},m);_i(n,"path",{d:`M${Kc} 0V${mo-jc}H${Jc}`,fill:"none",stroke:"#555"});for(let m of[0,.5,1]){let[x,g]=a.map(([d,y])=>Math.exp(d+m*(y-d)));f(Ze(x),{x:c(x),y:mo-jc+12,"text-anchor":"middle"}),f(Ze(g),{x:Kc-4,y:u(g)+3,"text-anchor":"end"})}f(t[0],{x:Jc,y:mo-12,"text-anchor":"end"}),f(t[1],{x:0,y:0,"text-anchor":"end",transform:"translate(9 0) rotate(-90)"});for(let[m,x]of e)_i(n,"circle",{cx:c(m),cy:u(x),r:1.6,fill:"#9a968d"});let h=r.map(([m,x,g])=>{let d=g?_i(n,"circle",{cx:c(m),cy:u(x),r:4.5,stroke:"#1652b8","stroke-width":1.5,class:"choice","data-layout":g}):_i(n,"path",{d:`M${c(m)-4} ${u(x)-4}l8 8m0 -8l-8 8`,stroke:"#1c1c1c","stroke-width":2});return _i(d,"title",{},`${i[g].label}: ${Ze(m)}, ${Ze(x)}`),g&&d.addEventListener("click",()=>s(g)),d});return{mark:m=>h.forEach(x=>x.setAttribute("fill",Number(x.dataset.layout)===m?"#1652b8":"#fff"))}}var Sm={type:"change"},ff={type:"start"},bm={type:"end"},Qc=new Fs,Mm=new In,XM=Math.cos(70*Yu.DEG2RAD),Sn=new G,Qn=2*Math.PI,Te={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},uf=1e-6,th=class extends pa{constructor(t,e=null){super(t,e),this.state=Te.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Gs.ROTATE,MIDDLE:Gs.DOLLY,RIGHT:Gs.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new an,this._lastTargetPosition=new G,this._quat=new an().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ao,this._sphericalDelta=new ao,this._scale=1,this._panOffset=new G,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new G,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=YM.bind(this),this._onPointerDown=qM.bind(this),this._onPointerUp=$M.bind(this),this._onContextMenu=eb.bind(this),this._onMouseWheel=KM.bind(this),this._onKeyDown=jM.bind(this),this._onTouchStart=QM.bind(this),this._onTouchMove=tb.bind(this),this._onMouseDown=ZM.bind(this),this._onMouseMove=JM.bind(this),this._interceptControlDown=nb.bind(this),this._interceptControlUp=ib.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Te.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Sm),this.update(),this.state=Te.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Te.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Qn:i>Math.PI&&(i-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Qc.origin.copy(this.object.position),Qc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Qc.direction))<XM?this.object.lookAt(this.target):(Mm.setFromNormalAndCoplanarPoint(this.object.up,this.target),Qc.intersectPlane(Mm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>uf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>uf||this._lastTargetPosition.distanceToSquared(this.target)>uf?(this.dispatchEvent(Sm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Qn/60*this.autoRotateSpeed*t:Qn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function qM(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function YM(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function $M(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(bm),this.state=Te.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function ZM(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Gs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Te.DOLLY;break;case Gs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Te.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Te.ROTATE}break;case Gs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Te.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Te.PAN}break;default:this.state=Te.NONE}this.state!==Te.NONE&&this.dispatchEvent(ff)}function JM(n){switch(this.state){case Te.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Te.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Te.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function KM(n){this.enabled===!1||this.enableZoom===!1||this.state!==Te.NONE||(n.preventDefault(),this.dispatchEvent(ff),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(bm))}function jM(n){this.enabled!==!1&&this._handleKeyDown(n)}function QM(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1){this.state=Te.NONE;break}this._handleTouchStartRotate(n),this.state=Te.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1){this.state=Te.NONE;break}this._handleTouchStartPan(n),this.state=Te.TOUCH_PAN;break;default:this.state=Te.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Te.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Te.TOUCH_DOLLY_ROTATE;break;default:this.state=Te.NONE}break;default:this.state=Te.NONE}this.state!==Te.NONE&&this.dispatchEvent(ff)}function tb(n){switch(this._trackPointer(n),this.state){case Te.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Te.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Te.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Te.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Te.NONE}}function eb(n){this.enabled!==!1&&n.preventDefault()}function nb(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ib(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var sb=new G(0,1,0);function eh(n,t,e=!1){let i=new Os({color:n,depthTest:!e,transparent:e}),s=new Ee(new $i(t,t,1,10),i),r=new Ee(new ra(2.6*t,6*t,14),i),o=new Xe;o.add(s,r),e&&(s.renderOrder=r.renderOrder=5);function a(l,c,u){o.visible=u>1e-6;let f=Math.max(u-6*t,.001);o.position.copy(l),o.quaternion.setFromUnitVectors(sb,c),s.scale.y=f,s.position.y=f/2,r.scale.setScalar(Math.min(1,u/(6*t))||1),r.position.y=Math.max(u,.001)-3*t*r.scale.x}return{object:o,point:a}}var rb=16250868,nh=.12,ob=40,ab=250,lb=.4;function dr(n,t,e="#1c1c1c"){let i=document.createElement("canvas");i.width=i.height=64;let s=i.getContext("2d");s.font="600 44px system-ui, sans-serif",s.textAlign="center",s.textBaseline="middle",s.lineWidth=8,s.strokeStyle="rgba(255,255,255,.85)",s.strokeText(n,32,34),s.fillStyle=e,s.fillText(n,32,34);let r=new io({map:new na(i),depthTest:!1}),o=new ta(r);return o.scale.setScalar(t),o.renderOrder=10,o}function cb(n,t){let e=new Xe,i=[11740702,3046706,1462968];return["x","y","z"].forEach((s,r)=>{let o=new G().setComponent(r,1),a=eh(i[r],n/90);a.point(t,o,n/4),e.add(a.object);let l=dr(s,n/9,`#${new re(i[r]).getHexString()}`);l.position.copy(t).addScaledVector(o,n/3.4),e.add(l)}),e}function hb(){let n=document.createElement("canvas").getContext("webgl2");if(!n)return!1;let t=n.getExtension("WEBGL_debug_renderer_info"),e=t?n.getParameter(t.UNMASKED_RENDERER_WEBGL):"";return n.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software/i.test(e)}function ub(n,t,e){let i=e?.6:1,[s,r]=[0,0],o=()=>Math.min(devicePixelRatio,2);function a(){r=0,n.getPixelRatio()!==o()&&t()}function l(){r||(s=0),clearTimeout(r),r=setTimeout(a,ab)}function c(u){r&&s&&u-s>ob&&(i=Math.max(lb,.85*i)),s=u;let f=o()*(r?i:1);n.getPixelRatio()!==f&&n.setPixelRatio(f)}return{moved:l,settle:c}}function Ys(n,t){let e=hb(),i=new Gc({canvas:n,antialias:!e});i.setClearColor(rb),i.localClippingEnabled=!0;let s=new Jo,r=.58*Math.hypot(...t),o=new $n(30,1,r/50,r*30);o.up.set(0,0,1);let a=new th(o,n),l=new ua(16777215,2.1);l.position.set(-.5,.65,.8),o.add(l,l.target),l.target.position.set(0,0,-1),s.add(o,new fa(16777215,1.5));let c=new da(Math.ceil(3*r/20)*20,Math.ceil(3*r/20)*2,12171698,14737626);c.rotation.x=Math.PI/2,c.position.z=-t[2]/2-r*.02;let u=new Xe;u.add(c,cb(r,new G(-.8*r,-.8*r,c.position.z))),s.add(u);let f=[],h=!1,p=0;function m(R){h=!1,g.settle(R??performance.now()),f.forEach(M=>M(o)),i.render(s,o),p+=1}function x(){h||requestAnimationFrame(m),h=!0}let g=ub(i,x,e);function d(R=4.3,M=0,_=!1){let b=_?o.position.clone().sub(a.target):new G(.57,-.68,.46),D=Math.max(1,1.25/o.aspect);a.target.set(0,0,M*r),o.position.copy(a.target).addScaledVector(b.normalize(),R*r*D),a.update(),x()}function y({center:R,radius:M}){d(1);let _=Math.min(1,o.aspect)*Math.sin(o.fov*Math.PI/360),b=o.position.clone().sub(a.target).normalize();a.target.copy(R),o.position.copy(R).addScaledVector(b,M/_),a.update()}function P(){let{clientWidth:R,clientHeight:M}=n;!R||!M||(i.setSize(R,M,!1),o.aspect=R/M,o.updateProjectionMatrix(),x())}function S(){g.moved(),x()}return a.addEventListener("change",S),new ResizeObserver(P).observe(n),n.addEventListener("keydown",R=>fb(R,o,a)),P(),d(),{renderer:i,scene:s,camera:o,controls:a,size:r,draw:m,redraw:x,moved:S,look:d,frame:y,before:f,ground:u,drawn:()=>p}}function fb(n,t,e){let i=new G().crossVectors(t.position,t.up).normalize(),s={ArrowLeft:[t.up,-nh],ArrowRight:[t.up,nh],ArrowUp:[i,-nh],ArrowDown:[i,nh]},r={"+":.9,"=":.9,"-":1/.9}[n.key],o=t.position.clone().sub(e.target);if(s[n.key])o.applyQuaternion(new an().setFromAxisAngle(...s[n.key]));else if(r)o.multiplyScalar(r);else return;n.preventDefault(),t.position.copy(e.target).add(o),e.update()}var gn={silicone:15521453,core:9086404,board:1733432,chip:2500134,north:13379876,south:2708152,cut:13208155,mould:11060382};function vs(n,t){let e=new pn;return e.setAttribute("position",new Ln(Kn(n[`${t}_mm`]),3)),e.setAttribute("normal",new Ln(Kn(n[`${t}_normals`]),3)),e.setIndex(new Ln(n[`${t}_triangles`].data,1)),e}function ih(n,t,e,i=gn.cut){t.clippingPlanes=e;let s=new Os({color:i,side:Un,clippingPlanes:e}),r=new Xe,o=new Ee(n,t),a=new Ee(n,s);return r.add(o,a),{group:r,front:o,back:a}}function Ca(n,t){let e=new mi({color:3159871,clippingPlanes:t});return new ps(new or(n,35),e)}function Em(n,t){let[e,i,s,r,o,a,l,c,u]=n;return new we().set(e,i,s,t[0],r,o,a,t[1],l,c,u,t[2],0,0,0,1)}function wm(n,t,e){let i=[];if(!n[`${t}_mm`])return i;let s=new mn({color:e});for(let r=0;r<n[`${t}_mm`].shape[0];r++){let o=fn(n[`${t}_half_mm`],r,3),a=new Ee(new Ai(...o.map(l=>2*l)),s);Tm(a,Em(fn(n[`${t}_axes`],r,9),fn(n[`${t}_mm`],r,3))),i.push(a)}return i}function Tm(n,t){t.decompose(n.position,n.quaternion,n.scale),n.userData.rest={position:n.position.clone(),quaternion:n.quaternion.clone()}}function db(n){let t=vs(n,"magnet_half"),e=t.clone().rotateX(Math.PI),[i,s]=["north","south"].map(r=>new mn({color:gn[r]}));return Array.from({length:n.magnet_mm.shape[0]},(r,o)=>{let a=new Xe;return a.add(new Ee(t,i),new Ee(e,s)),Tm(a,Em(fn(n.magnet_axes,o,9),fn(n.magnet_mm,o,3))),a})}function sh({content:n,arrays:t},e){let i=new Xe,s=e.size,r=new G(...n.away),o=n.size_mm.reduce((E,N,F)=>E+N*Math.abs(n.away[F]),0),a=Object.fromEntries(n.faces.map(E=>[E.number,new G(...E.normal)])),l=new In(new G(0,1,0),0),c=[],u=new mn({color:gn.silicone,transparent:!0}),f=ih(vs(t,"silicone"),u,c);f.front.renderOrder=2;let h=ih(vs(t,"core"),new mn({color:gn.core}),c,6258339);h.group.add(Ca(h.front.geometry,c));let p=db(t),m=wm(t,"boards",gn.board),x=wm(t,"chips",gn.chip);i.add(f.group,h.group,...p,...m,...x);let g=n.faces.map(E=>{let N=dr(String(E.number),s/8),F=a[E.number];return N.position.set(...E.centre_mm).addScaledVector(F,s*.09),N.userData={normal:F,rest:N.position.clone()},i.add(N),N});e.before.push(E=>{for(let N of g){let F=E.position.clone().sub(N.position);N.visible=i.visible&&F.dot(N.userData.normal)>0}});let d=Array.from(t.sensor_face.data),y=Array.from(t.magnet_face.data),P=n.magnets_in_shell?p:m,S=n.magnets_in_shell?[...m,...x]:p,R=E=>{let N=p.includes(E)?y[p.indexOf(E)]:d[(m.includes(E)?m:x).indexOf(E)];return a[N]},M=0;function _(E){M=E;let N=r.clone().multiplyScalar(.95*o*E);f.group.position.copy(N),g.forEach(F=>F.position.copy(F.userData.rest).add(N).addScaledVector(F.userData.normal,.2*s*E));for(let F of P)F.position.copy(b(F)).add(N).addScaledVector(R(F),.2*s*E);for(let F of S)F.position.copy(b(F)).addScaledVector(R(F),.16*s*E);e.redraw()}let b=E=>E.userData.moved??E.userData.rest.position;function D(E,N){c.length=0,E&&(l.normal.set(0,0,0).setComponent("xyz".indexOf(E),E==="y"?1:-1),l.constant=N*n.size_mm["xyz".indexOf(E)]/2,c.push(l)),[f,h].forEach(F=>F.back.visible=c.length>0),[f,h].forEach(F=>F.group.traverse(I=>I.material&&(I.material.needsUpdate=!0))),e.redraw()}function A(E){u.opacity=E,u.depthWrite=E>.95,e.redraw()}return D("",0),{root:i,silicone:f,core:h,faces:g,movers:P,explode:_,clip:D,fade:A,offset:()=>f.group.position,again:()=>_(M)}}function Am({content:n,arrays:t},e){let i=new Xe,s=[11060382,9745290,12760022,14272928],r=n.mould.map((l,c)=>{let u=l.name==="cast shell",f=new mn({color:u?gn.silicone:l.name.startsWith("core")?gn.core:s[c%s.length],side:gi,transparent:!u,opacity:u?1:.9}),h=new Ee(vs(t,`mould_${c}`),f);return h.add(Ca(h.geometry,[])),i.add(h),{...l,mesh:h,pull:new G(...l.pull_mm)}});function o(l){for(let{mesh:c,pull:u,begins:f,ends:h}of r){let p=Math.min(1,Math.max(0,(l-f)/(h-f)));c.position.copy(u).multiplyScalar(p)}e.redraw()}function a(){let l=new qi;for(let{mesh:c,pull:u}of r)c.geometry.computeBoundingBox(),l.union(c.geometry.boundingBox).union(c.geometry.boundingBox.clone().translate(u));return l.getBoundingSphere(new ds)}return o(0),i.visible=!1,{root:i,open:o,pieces:r,bounds:a}}var pb=2500;function Rm(n,{content:t,arrays:e}){let i=d=>n.querySelector(`[data-name="${d}"]`);n.hidden=!1;let s=Ys(i("canvas"),t.size_mm),[r]=t.layouts,o=!e.body_mm,a=[["body",gn.silicone,.18],["core",gn.core,.4]].filter(([d])=>o||e[`${d}_mm`]).map(([d,...y])=>({name:d,...gb(o?new Ai(2,2,2):vs(e,d),...y,s)})),l=Ss(s,()=>mf()),c=Ss(s,()=>Ra(gn.chip)),u=Ss(s,()=>Ra(gn.board)),f=new ps(new pn,new mi({color:14162842,depthTest:!1,transparent:!0}));f.renderOrder=4,s.scene.add(f),t.faces.forEach(d=>gf(d,s));let h={shown:Math.min(1,t.layouts.length-1),share:1},p=i("front")&&vm(i("front"),t,d=>g(d,1));function m(){let d=t.layouts[h.shown],y=h.share;a.forEach(S=>S.place(pf(r[S.name],d[S.name],y))),l.place(df(r.magnets,d.magnets,d.magnet_from,y)),c.place(df(r.chips,d.chips,d.sensor_from,y)),u.place(df(r.boards,d.boards,d.sensor_from,y));let P=d.magnets.flatMap((S,R)=>d.magnet_from[R]<0?[]:[...r.magnets[d.magnet_from[R]].at,...S.at]);f.geometry.setAttribute("position",new Fe(P,3)),f.geometry.computeBoundingSphere(),s.redraw()}function x(){let d=t.layouts[h.shown];i("scores").replaceChildren(...t.objectives.map((y,P)=>{let S=document.createElement("tr");return[y,Ze(r.scores[P]),Ze(d.scores[P])].forEach(R=>S.insertCell().append(R)),S})),i("after").textContent=d.label,i("share").setAttribute("aria-valuetext",`${Math.round(100*h.share)} % of the way to ${d.label}`),p?.mark(h.shown)}function g(d,y){Object.assign(h,{shown:d,share:y}),i("layout").value=String(d),i("share").value=String(100*y),x(),m()}return i("layout").append(...t.layouts.slice(1).map((d,y)=>new Option(d.label,y+1))),i("layout").addEventListener("change",()=>g(Number(i("layout").value),h.share)),i("share").addEventListener("input",()=>g(h.shown,Number(i("share").value)/100)),i("opacity").addEventListener("input",()=>a.forEach(d=>d.fade(Number(i("opacity").value)/100))),i("home").addEventListener("click",()=>s.look(4.3)),i("play").addEventListener("click",()=>mb(d=>g(h.shown,d))),g(h.shown,1),{host:n,view:s}}function mb(n){let t=performance.now(),e=matchMedia("(prefers-reduced-motion: reduce)").matches;function i(s){let r=e?1:Math.min(1,Math.max(0,(s-t)/pb));n(r),r<1&&requestAnimationFrame(i)}requestAnimationFrame(i)}var Cm=(n,t,e)=>n.map((i,s)=>i+e*(t[s]-i));function rh(n){let[t,e,i,s,r,o,a,l,c]=n;return new an().setFromRotationMatrix(new we().set(t,e,i,0,s,r,o,0,a,l,c,0,0,0,0,1))}function pf(n,t,e){let i=rh(n.axes).slerp(rh(t.axes),e);return{at:Cm(n.at,t.at,e),turn:i,half:Cm(n.half,t.half,e)}}function df(n,t,e,i){let s=(o,a)=>({...o,half:o.half.map(l=>l*a)}),r=n.filter((o,a)=>!e.includes(a));return[...t.map((o,a)=>pf(e[a]<0?s(o,0):n[e[a]],o,i)),...r.map(o=>pf(o,s(o,0),i))]}function Ss(n,t){let e=[];function i(s){for(;e.length<s.length;)e.push(t()),n.scene.add(e.at(-1));e.forEach((r,o)=>{r.visible=o<s.length&&Math.min(...s[o].half)>1e-4,r.visible&&(r.position.set(...s[o].at),r.quaternion.copy(s[o].turn),r.scale.set(...s[o].half))})}return{place:i}}var Ra=n=>new Ee(new Ai(2,2,2),new mn({color:n}));function mf(){let n=new Xe;for(let[t,e]of[[gn.north,.5],[gn.south,-.5]]){let i=new Ee(new $i(1,1,1,32),new mn({color:t}));i.rotation.x=Math.PI/2,i.position.z=e,n.add(i)}return n}function gb(n,t,e,i){let s=new mn({color:t,transparent:!0,opacity:e,depthWrite:!1}),r=new Ee(n,s);r.add(new ps(new or(n,35),new mi({color:3159871})));let o=Ss(i,()=>r);return{place:l=>o.place([l]),fade:l=>{s.opacity=e*2*l,i.redraw()}}}function gf(n,t){let e=dr(String(n.number),t.size/8),i=new G(...n.normal);e.position.set(...n.centre_mm).addScaledVector(i,t.size*.09),t.scene.add(e),t.before.push(s=>e.visible=s.position.clone().sub(e.position).dot(i)>0)}var _b=["map","explode","opacity","clip-axis","clip","opening"];function Lm(n){let t=!1,e=(s,r)=>{if(!t){t=!0;try{n.filter(o=>o!==s).forEach(r)}finally{t=!1}}};yb(n);for(let s of n){s.watchers.push(()=>e(s,r=>Pm(s,r))),s.view.controls.addEventListener("change",()=>e(s,r=>Im(s,r)));for(let r of["input","change"])s.host.addEventListener(r,o=>e(s,a=>xb(o,a)));s.find("open").addEventListener("click",()=>e(s,r=>r.find("open").click()))}let i=n.reduce((s,r)=>s.view.size>=r.view.size?s:r);e(i,s=>Im(i,s)),e(n[0],s=>Pm(n[0],s))}function Pm(n,t){let{face:e,place:i,step:s}=n.press.state,r=n.content.faces[e].number,o=t.content.faces.findIndex(f=>f.number===r);if(o<0)return;let[a,l]=n.press.xy(i),c=s?n.press.depths[s-1]:0,u=[0,...t.press.depths].map(f=>Math.abs(f-c));t.choose(o,t.near(o,a,l),u.indexOf(Math.min(...u)))}function Im(n,t){t.view.controls.target.copy(n.view.controls.target),t.view.camera.position.copy(n.view.camera.position),t.view.controls.update(),t.view.redraw()}function xb(n,t){let{name:e}=n.target.dataset;if(n.target.type==="radio"){let i=t.host.querySelector(`[type=radio][value="${n.target.value}"]`);if(i.closest("label").hidden)return;i.checked=!0,i.dispatchEvent(new Event(n.type))}else _b.includes(e)&&(t.find(e).value=n.target.value,t.find(e).dispatchEvent(new Event(n.type)))}function yb(n){for(let{stem:t}of n[0].content.maps){let e=n.map(r=>r.content.maps.find(o=>o.stem===t)),i=n.map((r,o)=>r.maps.endsOf(e[o])),s=[Math.min(...i.map(([r])=>r)),Math.max(...i.map(([,r])=>r))];n.forEach(r=>r.maps.fix(t,s))}}var oh=Math.sqrt(-2*Math.log(.05)),Dm=64,vb=.15,[Sb,Mb]=[16777215,1.06],Nm=[1,2,5,10,20,50,100];function bb(n){let t=new ro(new pn,new mi({color:n,depthTest:!1,transparent:!0}));return t.renderOrder=6,t}function ah({content:n,arrays:t},e,i,s,r){let o=new Xe;o.add(...[Sb,r].map(bb)),o.visible=!1;let a=new gs,l=t.place_xy_mm.shape[0],c=wb(n,t,i,s.size),u=null;function f(m,x){let{most:g}=i(m,x);o.visible=Number.isFinite(g);let d=`${m} ${x}`;if(!o.visible||u===d&&n.faces[m].flat)return;u=d;let y=new G(...fn(t.place_mm,m*l+x,3)),[P,S,R]=["x","y","normal"].map(M=>new G(...n.faces[m][M]));e.silicone.front.updateWorldMatrix(!0,!1),o.children.forEach((M,_)=>{let b=c*(_?1:Mb),D=h(m,x,y,[P,S,R],b);M.geometry.setAttribute("position",new Fe(D,3)),M.geometry.computeBoundingSphere()})}function h(m,x,g,[d,y,P],S){let{most:R,least:M,turn:_}=i(m,x),b=[],D=fn(t.place_xy_mm,x,2),A=hf(n.faces[m],D);for(let E=0;E<=Dm;E++){let N=2*Math.PI*E/Dm,[F,I]=[S*oh*R*Math.cos(N),S*oh*M*Math.sin(N)],B=[D[0]+F*Math.cos(_)-I*Math.sin(_),D[1]+F*Math.sin(_)+I*Math.cos(_)],X=hf(n.faces[m],B),z=g.clone().addScaledVector(d,X[0]-A[0]).addScaledVector(y,X[1]-A[1]),ht=n.faces[m].flat?z:p(z,P,2*S*oh*R+1);ht&&b.push(...ht.addScaledVector(P,vb).toArray())}return b}function p(m,x,g){a.set(m.clone().addScaledVector(x,g).add(e.offset()),x.clone().negate()),a.far=2*g;let[d]=a.intersectObject(e.silicone.front,!1);return d?d.point.sub(e.offset()):null}return{line:o,scale:c,draw:f,hide:()=>o.visible=!1}}function wb({faces:n},{place_xy_mm:t},e,i){let s=t.shape[0],r=n.flatMap((a,l)=>Array.from({length:s},(c,u)=>oh*e(l,u).most)).filter(Number.isFinite).sort((a,l)=>a-l),o=r[Math.floor(r.length/2)]??i;return Nm.find(a=>a*o>=i/45)??Nm.at(-1)}function Um(n,t,e){let{content:i,arrays:s}=n,{depth_mm:r,shown_steps:o}=i.press,[,a,l]=s.force_n.shape,c=s.sensor_mm.shape[0],u=t.silicone.front.geometry,f=Kn(s.silicone_mm),h=Kn(s.link_mm),p=new Float32Array(s.shape.shape[2]),m=Eb(i.tip,e.size),x=Array.from({length:c},()=>eh(14162842,e.size/130,!0)),[g,d]=[14162842,1842204].map(Q=>ah(n,t,z,e,Q)),y=new Xe,P=new Xe;P.add(...x.map(Q=>Q.object)),y.add(m,g.line,d.line),e.scene.add(y,P);let S=Array.from({length:c},(Q,st)=>new G(...fn(s.sensor_mm,st,3))),R=Array.from({length:c},(Q,st)=>fn(s.sensor_axes,st,9)),M={face:0,place:0,step:0},_=Q=>Q?s.force_n.data[(M.face*a+M.place)*l+Q-1]:0,b=()=>M.face*a+M.place;function D(Q){let st=_(Q);if(!Q||!st)return[];let $=r[Q-1],ft=o.length-1,it=o.findIndex(nt=>r[nt]>=$);it=it<0?ft:it;let gt=Math.max(0,it-1),mt=it===gt?1:Math.max(0,($-r[o[gt]])/(r[o[it]]-r[o[gt]]));return(it===gt?[[it,1]]:[[gt,1-mt],[it,mt]]).filter(([,nt])=>nt>0).map(([nt,lt])=>[nt,lt*st/(_(o[nt]+1)||st)])}function A(Q){p.fill(0);let{data:st,shape:$,step:ft}=s.shape,[,it,gt]=$;for(let[W,nt]of Q){let lt=nt*ft*r[o[W]],Dt=(M.face*it+W)*gt;for(let Ot=0;Ot<gt;Ot++)p[Ot]+=lt*st[(Dt+Ot)*a+M.place]}let mt=u.attributes.position;mt.array.set(f),s.link_vertex.data.forEach((W,nt)=>{let lt=p[s.link_source.data[nt]];for(let Dt=0;Dt<3;Dt++)mt.array[3*W+Dt]+=lt*h[3*nt+Dt]}),Q.length&&E(mt.array),mt.needsUpdate=!0,u.computeVertexNormals(),u.computeBoundingSphere()}function E(Q){let st=i.tip.radius_mm;if(!st)return;let{origin:$,axes:ft}=N(),it=$.clone().addScaledVector(ft[2],st-r[M.step-1]),gt=new G;for(let mt=0;mt<Q.length;mt+=3){if(gt.set(Q[mt]-it.x,Q[mt+1]-it.y,Q[mt+2]-it.z),gt.lengthSq()>=st*st)continue;let W=gt.dot(ft[2]),nt=-Math.sqrt(st*st-gt.lengthSq()+W*W)-W;Q[mt]+=nt*ft[2].x,Q[mt+1]+=nt*ft[2].y,Q[mt+2]+=nt*ft[2].z}}function N(){let Q=fn(s.place_axes,b(),9),st=[0,1,2].map($=>new G(Q[$],Q[3+$],Q[6+$]).normalize());return{origin:new G(...fn(s.place_mm,b(),3)),axes:st}}function F(Q){t.movers.forEach((st,$)=>{let ft=new G,it=new G;for(let[lt,Dt]of Q){let Ot=(b()*o.length+lt)*t.movers.length+$;ft.addScaledVector(new G(...fn(s.motion_mm,Ot,3)),Dt),it.addScaledVector(new G(...fn(s.motion_rad,Ot,3)),Dt)}let{position:gt,quaternion:mt}=st.userData.rest;st.userData.moved=gt.clone().add(ft);let W=it.length(),nt=new an().setFromAxisAngle(W?it.clone().divideScalar(W):new G(0,0,1),W);st.quaternion.copy(nt.multiply(mt))}),t.again()}function I(Q){return M.step?fn(s.counts,(b()*l+M.step-1)*c+Q,3):[0,0,0]}function B(){let Q=i.press.noise_counts,st=s.live.data;return S.map(($,ft)=>({sensor:ft,face:s.sensor_face.data[ft],counts:I(ft),noise:Q,live:[0,1,2].map(it=>st[3*ft+it]>0)}))}function X(){let Q=Math.log1p(32e3/Math.min(...i.press.noise_counts));B().forEach(({counts:st,noise:$,live:ft},it)=>{let gt=new G,mt=0;st.forEach((nt,lt)=>{ft[lt]&&(gt.addScaledVector(new G(...R[it].slice(3*lt,3*lt+3)),nt),mt+=(nt/$[lt])**2)});let W=gt.length()?.75*e.size*Math.log1p(Math.sqrt(mt))/Q:0;x[it].point(S[it],gt.normalize(),mt>1?W:0)})}function z(Q,st){let[$,ft,it]=fn(s.ellipse_mm2,Q*a+st,3),gt=($+it)/2,mt=Math.hypot(($-it)/2,ft);return{most:Math.sqrt(gt+mt),least:Math.sqrt(Math.max(0,gt-mt)),turn:Math.atan2(2*ft,$-it)/2}}function ht(Q,st,$){Object.assign(M,{face:Q,place:st,step:$});let ft=D($);A(ft),F(ft),X(),g.draw(Q,st),d.hide();let{origin:it,axes:gt}=N();m.position.copy(it).addScaledVector(gt[2],-($?r[$-1]:0)),m.quaternion.setFromUnitVectors(new G(0,0,1),gt[2]),Y()}function Y(){y.position.copy(t.offset()),y.visible=t.root.visible,P.visible=t.root.visible&&t.offset().lengthSq()<1e-6,e.redraw()}function tt(Q){Q?d.draw(Q.face,Q.place):d.hide(),e.redraw()}return{state:M,set:ht,hover:tt,xy:Q=>Array.from(s.place_xy_mm.data.subarray(2*Q,2*Q+2)),ringScale:g.scale,signals:B,circle:z,force:()=>_(M.step),depths:r,group:y,places:a,follow:Y}}function Eb({radius_mm:n},t){let e=new mn({color:7171445,transparent:!0,opacity:.55}),i=new Xe,s=n??t/20;if(n){let o=new Ee(new ar(s,40,20),e);o.position.z=s,i.add(o)}let r=new Ee(new $i(s*.45,n?s*.45:.1,t/3,24),e);return r.rotation.x=Math.PI/2,r.position.z=(n?s:0)+t/6,i.add(r),i.traverse(o=>o.renderOrder=3),i}var Tb=5,Ab=3e3,Fm=0;function Om(n,t){let e=x=>n.querySelector(`[data-name="${x}"]`),{content:i}=t;n.hidden=!1,n.querySelectorAll("[type=radio]").forEach(x=>{x.name=`scene-${Fm}`,x.checked=x.value==="object"}),Fm+=1;let s=Ys(e("canvas"),i.size_mm),r=sh(t,s),o=Am(t,s);s.scene.add(r.root,o.root);let a=$c(t,r,s),l=Um(t,r,s),c=Cb(l.signals()),u=[];function f(){let{face:x,place:g,step:d}=l.state,{x_mm:y,y_mm:P}=i.grid,S=P.length,R=d?l.depths[d-1]:0,M=d?i.press.force_error[d-1]:null,{most:_,least:b}=l.circle(x,g);e("place").textContent=`face ${i.faces[x].number} (${y[Math.floor(g/S)]}, ${P[g%S]}) mm`,e("travel").textContent=`${R.toFixed(2)} mm`,e("force").textContent=`${l.force().toFixed(2)} N`,e("error").textContent=M===null?"":`\xB1 ${(100*M).toFixed(1)} % by the mesh (rms)`,e("bound").textContent=`${Ze(_)} \xD7 ${Ze(b)} mm`,e("ring").textContent=l.ringScale>1?`rings drawn ${l.ringScale} times as large`:"",e("score").textContent=a.shown()?`${Ze(a.valueAt(x,g))} ${a.shown().unit}`:"\u2013";let D=l.signals().map(A=>({...A,number:c[A.sensor]}));_m(e("bars"),D),xm(e("counts"),D),e("depth").setAttribute("aria-valuetext",`${R} mm deep`)}function h(x,g,d){l.set(x,g,d),e("face").value=String(x),e("x").value=String(Math.floor(g/i.grid.y_mm.length)),e("y").value=String(g%i.grid.y_mm.length),e("depth").value=String(d),f(),u.forEach(y=>y(l.state))}Rb(e,i,l),Pb(e,{scene:t,object:r,mould:o,maps:a,press:l,choose:h,tell:f,view:s,content:i}),Db(e,{scene:t,view:s,object:r,maps:a,press:l,choose:h});let p=lh(l,t,0,0,0);return h(0,p,Math.ceil(l.depths.length/2)),r.fade(Number(e("opacity").value)/100),{host:n,find:e,content:i,view:s,maps:a,press:l,choose:h,near:(x,g,d)=>lh(l,t,x,g,d),watchers:u}}function Cb(n){let t={};return n.map(({face:e})=>t[e]=(t[e]??0)+1)}function Rb(n,t,e){let i=(s,r)=>new Option(r,s);n("face").append(...t.faces.map((s,r)=>i(r,s.number))),n("x").append(...t.grid.x_mm.map((s,r)=>i(r,`${s} mm`))),n("y").append(...t.grid.y_mm.map((s,r)=>i(r,`${s} mm`))),n("map").append(...t.maps.map(({stem:s,title:r})=>i(s,r))),n("depth").max=String(e.depths.length),n("mould-choice").hidden=!t.mould.length}function Pb(n,{scene:t,object:e,mould:i,maps:s,press:r,choose:o,tell:a,view:l,content:c}){let u=(m,x,g)=>n(m).addEventListener(x,g),f=m=>Number(n(m).value);u("explode","input",()=>{e.explode(f("explode")/100),r.follow(),l.look(4.3+f("explode")/45,f("explode")/220,!0)}),u("opacity","input",()=>e.fade(f("opacity")/100));let h=()=>e.clip(n("clip-axis").value,f("clip")/100);u("clip-axis","change",h),u("clip","input",h),u("map","change",()=>{let m=s.show(n("map").value);Zc(n("legend"),m),m&&(n("opacity").value="100"),e.fade(f("opacity")/100),a()});for(let m of["face","x","y"])u(m,"change",()=>{let[x,g]=[c.grid.x_mm[f("x")],c.grid.y_mm[f("y")]];o(f("face"),lh(r,t,f("face"),x,g),r.state.step)});u("depth","input",()=>o(r.state.face,r.state.place,f("depth")));let p=()=>i.root.visible?l.frame(i.bounds()):l.look(4.3);u("home","click",p);for(let m of n("scenes").querySelectorAll("input"))m.addEventListener("change",()=>{let x=n("scenes").querySelector("input:checked").value;e.root.visible=x==="object",i.root.visible=x==="mould",n("object-controls").hidden=x!=="object",n("mould-controls").hidden=x!=="mould",l.ground.visible=x==="object",r.follow(),p()});u("opening","input",()=>i.open(f("opening")/100)),u("open","click",()=>Ib(n,i))}function Ib(n,t){let e=performance.now(),i=matchMedia("(prefers-reduced-motion: reduce)").matches;function s(r){let o=i?1:Math.min(1,(r-e)/Ab);n("opening").value=String(100*o),t.open(o),o<1&&requestAnimationFrame(s)}requestAnimationFrame(s)}function lh(n,{arrays:t},e,i,s){let[r,o]=[0,1/0],{data:a}=t.place_xy_mm;for(let l=0;l<n.places;l++){let c=Math.hypot(a[2*l]-i,a[2*l+1]-s);c<o&&Number.isFinite(t.force_n.data[(e*n.places+l)*n.depths.length])&&([r,o]=[l,c])}return r}function Lb({x_mm:n,y_mm:t},e,i){return[n,t].every((s,r)=>Math.abs(e[r]-i[r])<=(s.length>1?s[1]-s[0]:1)/2+.001)}function Db(n,{scene:t,view:e,object:i,maps:s,press:r,choose:o}){let a=n("canvas"),l=new gs,{content:c}=t,u=i.silicone.front;function f(p){if(!i.root.visible)return null;let m=a.getBoundingClientRect(),x=new Yt((p.clientX-m.left)/m.width*2-1,1-(p.clientY-m.top)/m.height*2);l.setFromCamera(x,e.camera);let g=l.intersectObject(u,!1).find(({point:_})=>u.material.clippingPlanes.every(b=>b.distanceToPoint(_)>=0));if(!g)return null;let d=[g.face.a,g.face.b,g.face.c],y=Math.max(...d.map(_=>s.owner[_]));if(y<0)return null;let P=g.point.clone().sub(i.offset()),[S,R]=Aa(c.faces[y],P.x,P.y,P.z),M=lh(r,t,y,S,R);return{face:y,x:S,y:R,place:M,judged:Lb(c.grid,r.xy(M),[S,R])}}let h=null;a.addEventListener("pointerdown",p=>h=[p.clientX,p.clientY]),a.addEventListener("pointerup",p=>{let m=h&&Math.hypot(p.clientX-h[0],p.clientY-h[1])<Tb;h=null;let x=m&&f(p);x&&o(x.face,x.place,r.state.step||r.depths.length)}),a.addEventListener("pointerleave",()=>{r.hover(null),n("under").textContent=""}),a.addEventListener("pointermove",p=>{if(p.buttons)return;let m=f(p);if(r.hover(m?.judged?m:null),!m)return void(n("under").textContent="");let x=`face ${c.faces[m.face].number} (${m.x.toFixed(1)}, ${m.y.toFixed(1)}) mm`;if(!m.judged)return void(n("under").textContent=`${x}: not judged`);let{most:g,least:d}=r.circle(m.face,m.place),y=s.shown()?`${s.shown().title} ${Ze(s.valueAt(m.face,m.place))} ${s.shown().unit}; `:"";n("under").textContent=`${x}: ${y}\u03C3 ${Ze(g)} \xD7 ${Ze(d)} mm`})}var zm={most:NaN,least:NaN,turn:0},[_f,Bm]=[14162842,16777215];function km({scene:n,body:t,parts:e,maps:i,view:s,find:r}){let{content:o,arrays:a}=n,l=a.place_xy_mm.shape[0],c=Kn(a.silicone_normals),u=Kn(a.silicone_mm),f=[],h=(M,_)=>f.find(b=>b.face===M&&b.place===_)?.circle??zm,p=[0,1].map(()=>ah(n,t,h,s,_f)),[m,...x]=[Bm,_f,_f].map(M=>{let _=new Ee(new ar(s.size/(M===Bm?45:60),24,16),new mn({color:M,depthTest:!1,transparent:!0,opacity:.9}));return _.renderOrder=7,_.visible=!1,_});s.scene.add(...p.map(M=>M.line),m,...x);let g=(M,_,b)=>{M.position.fromArray(a.place_mm.data,3*(_*l+b)),M.userData.face=o.faces[_]},d=({centre_mm:M,normal:_},b)=>b.position.clone().sub(new G(...M)).dot(new G(..._))>0;s.before.push(M=>[m,...x].forEach(_=>_.visible=!!_.userData.face&&d(_.userData.face,M)));function y({face:M,place:_},b){let D=new G(...fn(a.place_mm,M*l+_,3)),[A,E]=[1/0,-1];i.owner.forEach((F,I)=>{if(F!==M)return;let B=Math.hypot(u[3*I]-D.x,u[3*I+1]-D.y,u[3*I+2]-D.z);B<A&&([A,E]=[B,I])});let N=E<0?o.faces[M].normal:c.subarray(3*E,3*E+3);return{origin:D,normal:new G(...N),profile:b}}function P(M,{counts:_,noise_counts:b,position_mm2:D,motions:A,skin_mm:E},N,F){f=M.map((I,B)=>({...I,circle:Nb(D[B])})),t.bend(f.map(I=>y(I,E))),e.move({face:M[0].face,motions:A}),p.forEach((I,B)=>{I.hide(),I.draw(0,NaN),f[B]&&I.draw(f[B].face,f[B].place)}),x.forEach((I,B)=>f[B]?g(I,f[B].face,f[B].place):I.userData.face=null),S(N,_,b,F),s.redraw()}function S(M,_,b,D){let A=f.map(({circle:{most:N,least:F}},I)=>`(${M[I].map(B=>B.toFixed(1)).join(", ")}) mm to ${Ze(N)} \xD7 ${Ze(F)} mm`),E=f.length>1?"Both presses are read from the same chips at once. ":"";r("pressed").textContent=`${D} N on face ${o.faces[f[0].face].number}: the place is told at ${A.join(" and at ")} (one standard deviation); a ring holds 95 of 100 readings. ${E}The skin is drawn as that of a flat layer. Change of this face's chips in counts, with one standard deviation of noise; bold stands out of it:`,r("press-head").hidden=!1,r("counts").replaceChildren(...Array.from({length:_.length/3},(N,F)=>{let I=document.createElement("tr");return I.append(Object.assign(document.createElement("th"),{textContent:`${F+1}`})),_.slice(3*F,3*F+3).forEach((B,X)=>{let z=I.insertCell();z.textContent=B===null?"\u2013":`${B.toFixed(0).replace("-","\u2212")} \xB1 ${b[X].toFixed(0)}`,z.style.fontWeight=Math.abs(B)>3*b[X]?"700":""}),I}))}function R(){f=[],t.bend([]),e.move(null),p.forEach(M=>M.hide()),x.forEach(M=>M.userData.face=null),r("pressed").textContent="No press.",r("press-head").hidden=!0,r("counts").replaceChildren(),s.redraw()}return{show:P,release:R,markWorst:(M,_)=>g(m,M,_)}}function Nb([n,t,,e]){if(n===null)return zm;let[i,s]=[(n+e)/2,Math.hypot((n-e)/2,t)];return{most:Math.sqrt(i+s),least:Math.sqrt(Math.max(0,i-s)),turn:Math.atan2(2*t,n-e)/2}}var Ub=1e3,ch=(n,t)=>Object.assign(document.createElement(n),t);function Vm({find:n,ask:t,frozen:e,now:i,renew:s,take:r}){let[o,a,l]=[!1,!1,null],c="";async function u(){if(a=!0,!(e||o)){o=!0;try{for(;;){a=!1;let m=await t("state",{design:i().design});if(f(m),m.scene!==i().scene&&s(),!m.work.running&&l&&await h(),!m.refining&&!m.work.running&&!a)break;await new Promise(x=>setTimeout(x,Ub))}}catch(m){n("trouble").textContent=m.message}o=!1}}function f({refined:m,work:x}){n("refined").textContent=m,n("improve").disabled=n("confirm").disabled=x.running,n("stop").disabled=!x.running,n("work-command").textContent=x.command,n("work-line").textContent=x.command&&`${x.running?"at work":x.failed?"ended early":"finished"}${x.line?`: ${x.line}`:""}`;let g=JSON.stringify(x.layouts);g!==c&&(c=g,n("layouts").replaceChildren(...x.layouts.map(({label:d,design:y})=>{let P=ch("li",{textContent:`${d} `});return P.append(ch("button",{type:"button",textContent:"take",onclick:()=>r(y)})),P})))}async function h(){let{rows:m,channels:x}=await t("confirmed",l);l=null;let g=({page:d,chain:y})=>d===null||y===null?"\u2013":Ze(y/d);n("confirmed").replaceChildren(...m.map(d=>{let y=ch("tr",{});return y.append(ch("th",{textContent:d.name})),[d.page,d.chain].forEach(P=>y.insertCell().append(P===null?"\u221E":Ze(P))),y.insertCell().append(g(d)),y})),n("confirmed-head").hidden=!m.length,n("confirmed-note").textContent=m.length&&x==="all"?"The chain reads the chips of all faces, the page those of the pressed face: part of the difference.":""}async function p(m,x){try{let{design:g,force:d}=i();await t(m,{design:g,force_n:d,...x}),n("trouble").textContent="",m==="confirm"&&(l={design:g,force_n:d}),await u()}catch(g){n("trouble").textContent=g.message}}return n("improve").addEventListener("click",()=>p("improve",{seconds:Number(n("seconds").value)})),n("confirm").addEventListener("click",()=>p("confirm",{})),n("stop").addEventListener("click",()=>p("stop",{})),{watch:u}}var Gm={position:["Error of the place, one standard deviation","mm"],force:["Error of the force, one standard deviation","N"],least:["Least force that is felt","N"]},Hm=.1,Wm=.95,Fb=14687012,Ob=[.5,2],Xm=["size-x","size-y","size-z"],Bb=4,zb=300,kb=1e9,$s=n=>JSON.parse(JSON.stringify(n)),Pa=(n,t)=>Object.assign(document.createElement(n),t),qm=(n,t)=>n.textContent!==t&&(n.textContent=t),Zm=n=>Math.round(n/Hm)/(1/Hm);async function Vb(n,t){let e={method:"POST",body:JSON.stringify(t),headers:{"Content-Type":"application/json"}},i=await fetch(`/${n}`,e).catch(()=>{throw new Error("The server does not answer. Start instobj explore again on the same port: this page keeps the design.")}),s=await i.json();if(!i.ok)throw new Error(s.error??i.statusText);return s}function Gb(n){let t=JSON.parse(n.textContent);return async(e,{figure:i,force_n:s,face:r,places:o})=>e==="limits"||e==="range"?t[e]:e==="judge"?t[`judge ${i} ${s}`]:t[`press ${r} ${s}`][o[0]]}async function Ym(n){let t=document.getElementById("scene");if(t)return er(Ga(t.textContent));let e=await fetch("/scene",n&&{method:"POST",body:JSON.stringify({design:n}),headers:{"Content-Type":"application/json"}});return er(new Uint8Array(await e.arrayBuffer()))}async function Hb(){let n=W=>document.querySelector(`[data-name="${W}"]`),t=await Ym(),{content:e,arrays:i}=t,s=document.getElementById("answers"),r=s?Gb(s):Vb;document.body.classList.toggle("frozen",!!s),n("name").textContent=s?`${e.name}, to look at and press`:`${e.name}, explored`,s&&(n("hint").textContent="drag: turn \xB7 shift and click: press"),e.forces_n.forEach(W=>n("force").append(new Option(`${W} N`,W))),e.ranges_mt.forEach(W=>n("range").append(new Option(`\xB1${W} mT`,W))),e.silicones.forEach(W=>n("silicone").append(new Option(W))),n("of-size").hidden=!e.sizable,n("force").value=String(e.forces_n[Math.floor(e.forces_n.length/2)]);let o=Ys(n("canvas"),e.size_mm),a=new Set(o.scene.children),l={design:$s(e.design),answer:null,broken:[],used:null,pinned:null,chosen:null,presses:[]},c={past:[],future:[]},u=[],f,h,p,m,x;function g(W){t=W,{content:e,arrays:i}=W,o.before.length=0,o.scene.children.filter(nt=>!a.has(nt)).forEach(nt=>{o.scene.remove(nt),nt.traverse(lt=>lt.geometry?.dispose())}),h=i.place_xy_mm.shape[0],i.map_live={data:new Float32Array(e.faces.length*h).fill(NaN)},e.maps=[{stem:"live",weak:"high",log:!0}],f=Zb(t,o),p=$c(t,f,o),m=Kb(o,e),x=km({scene:t,body:f,parts:m,maps:p,view:o,find:n}),l.presses=[],n("accuracy").textContent=e.accuracy,f.fade(Number(n("opacity").value)/100)}g(t);let[d,y,P]=[!1,!1,0],[S,R]=[!1,!1],M=W=>({design:W,figure:n("figure").value,force_n:Number(n("force").value)});async function _(W){if(W&&(P=P||W),d)return void(y=!0);d=!0;let nt=P;P=0;try{l.answer=await b(l.design),n("trouble").textContent="",A(),nt&&requestAnimationFrame(()=>requestAnimationFrame(()=>u.push(performance.now()-nt))),l.presses.length&&await ft(l.presses),D(),e.scene.endsWith("full")||gt.watch()}catch(lt){n("trouble").textContent=lt.message}if(d=!1,y)return y=!1,void _();await r("range",{design:l.design}).then(lt=>l.used=lt.range_used,()=>l.used=null),E()}async function b(W){let nt=await r("judge",M(W));for(;nt.scene!==e.scene;)g(await Ym(W)),nt=await r("judge",M(W));return nt}async function D(){if(S)return void(R=!0);S=!0;do{R=!1;let W=new Promise(nt=>setTimeout(nt,zb));await r("limits",{design:l.design}).catch(({message:nt})=>({broken:[{text:nt,magnets:[],sensors:[],faces:[]}]})).then(F),await W}while(R);S=!1}function A(){let{answer:W,pinned:nt}=l,lt=n("difference").checked&&nt?.answer.scene===W.scene,[[Dt,Ot],Xt]=[Gm[n("figure").value],n("force").value];W.values.forEach((he,ye)=>{i.map_live.data[ye]=he===null?i.there.data[ye]?kb:NaN:lt?he/nt.answer.values[ye]:he}),Object.assign(e.maps[0],lt?{title:"Now over pinned; above 1 is worse",unit:"times"}:{title:Dt,unit:Ot},{force_n:Xt}),p.fix("live",lt?Ob:l.ends??=qb(W.values.filter(he=>he>0))),Zc(n("legend"),p.show("live")),m.place(W.parts),o.moved(),I(),E(),st()}function E(){let{answer:W,pinned:nt,used:lt}=l,Dt=n("figure").value,[Ot,Xt]=[W.summary[Dt],nt?.answer.summary[Dt]],he=Gm[Dt][1],ye=[[`half of the places are below, ${he}`,Ot.median,Xt?.median],[`95 of 100 places are below, ${he}`,Ot.percentile_95,Xt?.percentile_95],[`worst place, ${he}`,Ot.worst,Xt?.worst],["chips' range in use, %",lt?100*lt:"\u2026",nt?.used?100*nt.used:""],["magnets; chips",`${W.magnets}; ${W.sensors}`,nt?`${nt.answer.magnets}; ${nt.answer.sensors}`:""],["price of both, \u20AC; work by hand, min",W.price_and_minutes.map(Math.round).join("; "),nt?.answer.price_and_minutes.map(Math.round).join("; ")]];n("numbers").rows.length||n("numbers").replaceChildren(...ye.map(([Ke])=>Xb(Ke,["",""]))),ye.forEach(([Ke,...me],sn)=>[Ke,...me].forEach((Ne="",je)=>{qm(n("numbers").rows[sn].cells[je],Ne===null?"\u221E":typeof Ne=="number"?Ze(Ne):Ne)}));let[ze,ve]=N(Ot.place);qm(n("worst"),`The worst place is on face ${e.faces[Ot.face].number} at (${ze.toFixed(1)}, ${ve.toFixed(1)}) mm, at the white ball.`),x.markWorst(Ot.face,Ot.place)}let N=W=>Array.from(i.place_xy_mm.data.subarray(2*W,2*W+2));function F({broken:W}){l.broken=W;let nt=W.length?W.map(Wb):["All limits of instobj check are kept."];l.answer.beyond&&nt.push("A part lies where the quick model knows no motions: it is judged at the nearest place that it knows."),n("limits").replaceChildren(...nt.map(lt=>Pa("li",{textContent:lt,className:W.length?"broken":"kept"}))),I(),E()}function I(){m.paint(l.broken,l.chosen,ht(l.design)),o.redraw()}function B(){c.past.push($s(l.design)),c.future=[]}function X(W,nt){c[nt].push(l.design),l.design=c[W].pop(),l.chosen=null,_()}let z=W=>{B(),W(l.design),_(performance.now())},ht=({magnets:W})=>!Array.isArray(W.positions_mm[0][0]);function Y({magnets:W,sensors:nt},lt){return lt==="magnet"?ht({magnets:W})?[W.positions_mm]:W.positions_mm:nt.positions_mm??=$s(l.answer.shown.sensors_mm)}function tt(W,nt,lt){let Dt=Y(W,nt);return Dt[Dt.length===e.faces.length?lt:(e.faces[lt].number-1)%Dt.length]}let rt=()=>l.design.magnets.depth_mm??=$s(l.answer.shown.depth_mm),Q=({kind:W,face:nt,number:lt})=>tt($s(l.design),W,nt)[lt];function st(){n("undo").disabled=!c.past.length,n("redo").disabled=!c.future.length;let{chosen:W,design:nt}=l,lt=W?.kind==="magnet";n("of-magnet").hidden=!lt||!e.magnets_in_shell,n("of-tilt").hidden=!lt||!e.tiltable,n("remove").disabled=!W,n("part").textContent=W?`Part: ${lt?"magnet":"chip"} ${W.number+1} of face ${e.faces[W.face].number}`:"Part: none chosen, click one",n("alike").textContent=ht(nt)?"A magnet moves alike on every face; a chip on its face alone.":"Magnets and chips move on their face alone; depth, pole and tilt are alike on every face.",["x","y"].forEach((Dt,Ot)=>$(Dt,W&&Q(W)[Ot])),lt&&($("depth",(nt.magnets.depth_mm??l.answer.shown.depth_mm)[W.number]),["tilt-x","tilt-y"].forEach((Dt,Ot)=>$(Dt,nt.magnets.tilt_deg[W.number][Ot])),n("north").value=nt.magnets.north[W.number]),n("range").value=String(nt.sensors.range_mt),$("chip-depth",nt.sensors.depth_below_core_face_mm),$("thickness",nt.shell.thickness_mm),n("silicone").value=nt.silicone.name,Xm.forEach((Dt,Ot)=>$(Dt,nt.body.size_mm[Ot]))}function $(W,nt){let lt=n(W);lt.disabled=nt==null,document.activeElement!==lt&&(lt.value=lt.disabled?"":String(nt))}async function ft(W){if(l.presses=W,n("release").disabled=!W.length,!W.length)return x.release();let nt=Number(n("force").value),[{face:lt}]=W,Dt={design:l.design,face:e.faces[lt].number,places:W.map(({place:Xt})=>Xt),force_n:nt},Ot=await r("press",Dt);l.presses===W&&x.show(W,Ot,W.map(({place:Xt})=>N(Xt)),nt)}let it=(W,nt,lt)=>n(W).addEventListener(nt,lt),gt=Vm({find:n,ask:r,frozen:!!s,now:()=>({design:l.design,scene:e.scene,force:Number(n("force").value)}),renew:()=>_(),take:W=>z(()=>{l.design=$s(W),l.chosen=null})});async function mt(){l.ends=null,l.pinned&&(l.pinned.answer=await r("judge",M(l.pinned.design))),_()}it("figure","change",mt),it("force","change",mt),it("fit","click",()=>{l.ends=null,A()}),it("difference","change",A),it("opacity","input",()=>f.fade(Number(n("opacity").value)/100)),it("undo","click",()=>X("past","future")),it("redo","click",()=>X("future","past")),document.addEventListener("keydown",({key:W,ctrlKey:nt,metaKey:lt,target:Dt})=>(nt||lt)&&!Dt.matches("input")&&{z:n("undo"),y:n("redo")}[W]?.click()),it("pin","click",()=>{l.pinned=$s({design:l.design,answer:l.answer,used:l.used}),n("difference").disabled=!1,A()}),it("save","click",async()=>{try{let W=await r("save",{design:l.design}),nt=Pa("p",{className:"note",textContent:W.comments_kept?`Saved in ${W.file}; its comments stayed.`:`Saved in ${W.file}; the comments of the first file could not be kept.`});n("commands").replaceChildren(nt,...W.commands.map(lt=>Pa("code",{textContent:lt}))),n("trouble").textContent=""}catch(W){n("trouble").textContent=W.message}}),["x","y"].forEach((W,nt)=>it(W,"change",()=>z(()=>tt(l.design,l.chosen.kind,l.chosen.face)[l.chosen.number][nt]=Number(n(W).value)))),it("depth","change",()=>z(()=>rt()[l.chosen.number]=Number(n("depth").value))),["tilt-x","tilt-y"].forEach((W,nt)=>it(W,"change",()=>z(({magnets:lt})=>lt.tilt_deg[l.chosen.number][nt]=Number(n(W).value)))),it("north","change",()=>z(({magnets:W})=>W.north[l.chosen.number]=n("north").value)),it("range","change",()=>z(({sensors:W})=>W.range_mt=Number(n("range").value))),it("chip-depth","change",()=>z(({sensors:W})=>W.depth_below_core_face_mm=Number(n("chip-depth").value))),it("thickness","change",()=>z(({shell:W})=>W.thickness_mm=Number(n("thickness").value))),it("silicone","change",()=>z(({silicone:W})=>W.name=n("silicone").value)),Xm.forEach((W,nt)=>it(W,"change",()=>z(lt=>lt.body.size_mm[nt]=Number(n(W).value)))),it("release","click",()=>ft([]));for(let W of["magnet","sensor"])it(`add-${W}`,"click",()=>z(nt=>{Y(nt,W).forEach(lt=>lt.push(Yb(lt,e.faces[0]))),W==="magnet"&&$m(nt.magnets,lt=>lt.push($s(lt.at(-1))))}));it("remove","click",()=>z(W=>{let{kind:nt,number:lt}=l.chosen;Y(W,nt).forEach(Dt=>Dt.splice(lt,1)),nt==="magnet"&&$m(W.magnets,Dt=>Dt.splice(lt,1)),l.chosen=null})),jb({stage:document.querySelector(".stage"),canvas:n("canvas"),view:o,now:()=>({body:f,parts:m,content:e,maps:p}),frozen:!!s,choose(W){l.chosen=W,I(),st()},begin:B,move({kind:W,face:nt,number:lt},Dt,Ot){tt(l.design,W,nt)[lt]=Dt,_(Ot)},press(W,nt,lt,Dt){let Ot=Array.from({length:h},(ze,ve)=>i.there.data[W*h+ve]?Math.hypot(N(ve)[0]-nt,N(ve)[1]-lt):1/0),Xt={face:W,place:Ot.indexOf(Math.min(...Ot))},[he]=l.presses,ye=Dt&&!s&&he?.face===W&&he.place!==Xt.place;ft(ye?[he,Xt]:[Xt]).catch(({message:ze})=>n("trouble").textContent=ze)}}),await _(),gt.watch(),window.instobjExplore={state:()=>l,idle:()=>!d&&!y&&!S,exact:()=>e.scene.endsWith("full"),latencies:()=>u,forget:()=>u.length=0,where:(W,nt)=>m.where(W,nt,o),at:(W,nt)=>m.at(W,nt),dent:()=>f.deepest(),map:()=>Array.from(i.map_live.data)},document.getElementById("instobj-explore").dataset.ready="yes"}function Wb({text:n,magnets:t,sensors:e}){let i=[...t.map(s=>`magnet ${s+1}`),...e.map(s=>`chip ${s+1}`)];return i.length?`${i.join(", ")}: ${n}`:n}function Xb(n,t){let e=Pa("tr",{});return e.append(Pa("th",{textContent:n})),t.forEach(i=>e.insertCell().append(i)),e}var qb=n=>[Math.min(...n),Math.max(...n)];function $m(n,t){Object.entries(n).forEach(([e,i])=>e!=="positions_mm"&&Array.isArray(i)&&t(i))}function Yb(n,t){let i=Array.from({length:81},(r,o)=>[o%9/4-1,Math.floor(o/9)/4-1]).map(r=>r.map((o,a)=>Zm(.55*o*t.half_mm[a]))),s=i.map(r=>Math.min(...n.map(([o,a])=>Math.hypot(o-r[0],a-r[1])),1/0));return i[s.indexOf(Math.max(...s))]}function $b(n,t){return t.position.clone().sub(new G(...n.centre_mm)).dot(new G(...n.normal))>0}function Zb({content:n,arrays:t},e){let i=new mn({color:gn.silicone,transparent:!0}),s=ih(vs(t,"silicone"),i,[]);if(s.back.visible=!1,s.front.renderOrder=2,e.scene.add(s.group,Ca(s.front.geometry,[])),t.core_mm){let u=new Ee(vs(t,"core"),new mn({color:gn.core,transparent:!0,opacity:.35,depthWrite:!1}));u.add(Ca(u.geometry,[])),e.scene.add(u)}n.faces.forEach(u=>gf(u,e));let r=u=>{i.opacity=u,i.depthWrite=u>.95,e.redraw()},o=new G,a=Kn(t.silicone_mm);function l(u){let{position:f}=s.front.geometry.attributes;f.array.set(a),u.forEach(h=>Jb(f.array,a,h,n.thickness_mm)),f.needsUpdate=!0,s.front.geometry.computeVertexNormals()}return{silicone:s,offset:()=>o,fade:r,bend:l,deepest:()=>s.front.geometry.attributes.position.array.reduce((u,f,h)=>Math.max(u,Math.abs(f-a[h])),0)}}function Jb(n,t,{origin:e,normal:i,profile:s},r){let[o,a]=[new G,s.at(-1)[0]],l=s[1][0];for(let c=0;c<t.length;c+=3){o.set(t[c]-e.x,t[c+1]-e.y,t[c+2]-e.z);let u=-o.dot(i),f=o.addScaledVector(i,u).length();if(f>=a||u>=r)continue;let h=Math.min(s.length-2,Math.floor(f/l)),[p,m]=[1,2].map(g=>s[h][g]+(f/l-h)*(s[h+1][g]-s[h][g])),x=1-Math.max(0,u)/r;o.multiplyScalar(f?m/f:0).addScaledVector(i,-p),n[c]+=x*o.x,n[c+1]+=x*o.y,n[c+2]+=x*o.z}}function Kb(n,t){let e={magnet:[],sensor:[],board:[]},i={magnet:Ss(n,()=>o("magnet",mf())),sensor:Ss(n,()=>o("sensor",Ra(gn.chip))),board:Ss(n,()=>o("board",Ra(gn.board)))},s=!t.magnets_in_shell,r={};function o(_,b){return b.traverse(D=>D.material&&Object.assign(D.material,{transparent:!0,opacity:.9})),b.traverse(D=>D.material&&(D.renderOrder=3)&&(D.userData.colour=D.material.color.getHex())),e[_].push(b),b}let a=s?"board":"magnet",[l,c]=[null,null];function u(_){l=_;let{magnets:b,chips:D,boards:A}=_;r={magnet:b.length,sensor:A.length,board:A.length};for(let[E,N]of[["magnet",b],["sensor",D],["board",A]])i[E].place(N.map((F,I)=>({...F,...f(E,I,F),half:F.half})))}function f(_,b,{at:D,axes:A}){let E=rh(A),N=Math.floor(b/x(_)),F=_===a&&c?.face===N?c.motions[b%x(_)]:null;if(!F||F.includes(null))return{at:D,turn:E};let{x:I,y:B,normal:X}=t.faces[N],z=(tt,rt,Q)=>new G().addScaledVector(new G(...I),tt).addScaledVector(new G(...B),rt).addScaledVector(new G(...X),Q),ht=z(...F.slice(3)),Y=ht.length();return Y&&E.premultiply(new an().setFromAxisAngle(ht.divideScalar(Y),Y)),{at:z(...F).add(new G(...D)).toArray(),turn:E}}function h(_){c=_,l&&u(l)}let p=Ss(n,()=>dr("!",1,"#e01b24")),m=[],x=_=>r[_]/t.faces.length,g=_=>(_==="sensor"&&s?e.board:e[_]).slice(0,r[_]),d=(_,b)=>t.faces[Math.floor(b/x(_))],y=(_,b)=>m.some(D=>D[`${_}s`].includes(b%x(_))&&(!D.faces.length||D.faces.includes(d(_,b).number)));n.before.push(_=>{for(let D of["magnet","sensor","board"])e[D].slice(0,r[D]).forEach((A,E)=>A.visible=$b(d(D,E),_));let b=["magnet","sensor"].flatMap(D=>g(D).filter((A,E)=>A.visible&&y(D,E)));p.place(b.map(D=>({at:D.position.toArray(),turn:D.quaternion,half:Array(3).fill(n.size/6)})))});function P(_,b,D){m=_;for(let A of["magnet","sensor"])g(A).forEach((E,N)=>{let F=b?.kind===A&&b.number===N%x(A)&&(d(A,N)===t.faces[b.face]||A==="magnet"&&D),I=y(A,N);E.traverse(B=>{B.material?.color.setHex(I?Fb:B.userData.colour),B.material?.emissive.setHex(I?6291456:F?5587968:0)})})}function S(_){let b=["magnet","sensor"].flatMap(A=>{let E=g(A).filter(N=>N.visible);return _.intersectObjects(E,!0).map(N=>({...N,kind:A,index:g(A).findIndex(F=>F===N.object||F===N.object.parent)}))}),[D]=b.filter(({index:A})=>A>=0).sort((A,E)=>A.distance-E.distance);return D&&{kind:D.kind,face:Math.floor(D.index/x(D.kind)),number:D.index%x(D.kind),at:g(D.kind)[D.index].position.clone()}}function R(_,b,{camera:D,renderer:A}){let E=A.domElement.getBoundingClientRect(),N=g(_)[b].position.clone().project(D);return[E.left+(N.x+1)/2*E.width,E.top+(1-N.y)/2*E.height]}return{place:u,move:h,paint:P,under:S,where:R,at:(_,b)=>g(_)[b].position.toArray()}}function jb({stage:n,canvas:t,view:e,now:i,frozen:s,choose:r,begin:o,move:a,press:l}){let c=new gs,[u,f]=[new In,new G],h=null;function p(x){let g=t.getBoundingClientRect();c.setFromCamera(new Yt((x.clientX-g.left)/g.width*2-1,1-(x.clientY-g.top)/g.height*2),e.camera)}function m(x){let{body:g,content:d,maps:y}=i(),[P]=c.intersectObject(g.silicone.front,!1),S=P?Math.max(...[P.face.a,P.face.b,P.face.c].map(R=>y.owner[R])):-1;S>=0&&l(S,...Aa(d.faces[S],P.point.x,P.point.y,P.point.z),x)}n.addEventListener("pointerdown",x=>{if(x.target!==t||x.button)return;if(p(x),x.shiftKey)return x.stopPropagation(),m(x.altKey);let{parts:g,content:d}=i(),y=!s&&g.under(c);if(!y)return;x.stopPropagation();let P=new G(...d.faces[y.face].normal);u.setFromNormalAndCoplanarPoint(P,y.at),c.ray.intersectPlane(u,f),h={...y,from:[x.clientX,x.clientY],off:y.at.sub(f),moved:!1},r({kind:y.kind,face:y.face,number:y.number}),t.setPointerCapture(x.pointerId)},!0),t.addEventListener("pointermove",x=>{if(!h||!h.moved&&Math.hypot(x.clientX-h.from[0],x.clientY-h.from[1])<Bb||(p(x),!c.ray.intersectPlane(u,f)))return;h.moved||o(),h.moved=!0;let g=i().content.faces[h.face],d=f.add(h.off).sub(new G(...g.centre_mm)),y=[g.x,g.y].map((P,S)=>Zm(Math.min(Wm*g.half_mm[S],Math.max(-Wm*g.half_mm[S],d.dot(new G(...P))))));a(h,y,x.timeStamp)});for(let x of["pointerup","pointercancel"])t.addEventListener(x,()=>h=null)}document.getElementById("instobj-explore")&&Hb().catch(n=>{document.querySelector('[data-name="trouble"]').textContent=`The page cannot start: ${n.message}.`,console.warn(n)});function Jm(n){let t=n.attributes.position.array,e=n.index.array,i=new Float32Array(t.length),[s,r]=[0,0],o=new Float32Array(0);function a(u,f){[s,r]=[192,Math.max(1,Math.round(192/f))],o.length!==s*r&&(o=new Float32Array(s*r)),o.fill(0);let h=[0,0,0];for(let p=0;p<t.length;p+=3)u(t[p],t[p+1],t[p+2],h),i[p]=h[0]*s,i[p+1]=h[1]*r,i[p+2]=1/h[2];for(let p=0;p<e.length;p+=3)l(3*e[p],3*e[p+1],3*e[p+2])}function l(u,f,h){let[p,m,x,g,d,y]=[i[u],i[u+1],i[f],i[f+1],i[h],i[h+1]],P=(x-p)*(y-m)-(d-p)*(g-m);if(P>=0)return;let S=Math.max(0,Math.ceil(Math.min(p,x,d)-.5)),R=Math.min(s-1,Math.floor(Math.max(p,x,d)-.5)),M=Math.max(0,Math.ceil(Math.min(m,g,y)-.5)),_=Math.min(r-1,Math.floor(Math.max(m,g,y)-.5));for(let b=M;b<=_;b++)for(let D=S;D<=R;D++){let[A,E]=[D+.5,b+.5],N=((A-p)*(y-m)-(d-p)*(E-m))/P,F=((x-p)*(E-m)-(A-p)*(g-m))/P;if(N<0||F<0||N+F>1)continue;let I=i[u+2]+N*(i[f+2]-i[u+2])+F*(i[h+2]-i[u+2]),B=b*s+D;I>o[B]&&(o[B]=I)}}function c(u,f,h,p){let[m,x]=[Math.floor(u*s),Math.floor(f*r)];if(m<0||x<0||m>=s||x>=r)return!1;let g=o[x*s+m];return g>0&&1/g<h-p}return{draw:a,hides:c}}var hh="#d81b9a",Qb="#0b5c3b",tw=1.6,Km=.4,ew=.05,xf=40,uh=10,nw=Array.from({length:xf+1},(n,t)=>[Math.cos(2*Math.PI*t/xf),Math.sin(2*Math.PI*t/xf)]),Zs=(n,t,e)=>[n[0]+e*t[0],n[1]+e*t[1],n[2]+e*t[2]],jm=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2];function Qm([n,t,e]){let i=Math.abs(e)<.9?[-t,n,0]:[0,-e,t],s=Math.hypot(...i),[r,o,a]=i.map(l=>l/s);return[[r,o,a],[t*a-e*o,e*r-n*a,n*o-t*r]]}function tg(n,t,e){let i=t.getContext("2d"),s=Jm(e),r=n.size/40,o=new G,[a,l,c,u]=[0,0,1,1],f=n.camera.projectionMatrix.elements,[h,p]=[[],[]];function m(A,E,N,F){let I=f,B=I[3]*A+I[7]*E+I[11]*N+I[15];F[0]=.5+(I[0]*A+I[4]*E+I[8]*N+I[12])/(2*B),F[1]=.5-(I[1]*A+I[5]*E+I[9]*N+I[13])/(2*B),F[2]=B}function x(A){let E=[0,0,0];return m(...A,E),{x:E[0]*a,y:E[1]*l,far:E[2],hidden:s.hides(...E,r)}}function g(A){A.updateMatrixWorld(),f=A.projectionMatrix.clone().multiply(A.matrixWorldInverse).elements,A.getWorldPosition(o),c=Math.min(devicePixelRatio,2),[a,l]=[t.clientWidth,t.clientHeight],u=A.projectionMatrix.elements[5]*l/2,(t.width!==Math.round(a*c)||t.height!==Math.round(l*c))&&([t.width,t.height]=[Math.round(a*c),Math.round(l*c)]),s.draw(m,A.aspect),_()}n.before.push(g);function d(A,E,N){let[F,I]=[new Path2D,new Path2D],B=null;for(let X=1;X<A.length;X++){let z=A[X-1].hidden||A[X].hidden?I:F;z!==B&&z.moveTo(A[X-1].x,A[X-1].y),z.lineTo(A[X].x,A[X].y),B=z}[i.strokeStyle,i.lineWidth]=[E,N],i.stroke(F),i.globalAlpha=Km,i.setLineDash([4,3]),i.stroke(I),i.setLineDash([]),i.globalAlpha=1}function y({point:A,normal:E}){return jm([o.x-A[0],o.y-A[1],o.z-A[2]],E)<0}function P(A){let E=Number.isFinite(A.radius)?Math.max(A.radius,.05):.05,[N,F]=Qm(A.normal),I=Zs(A.point,A.normal,.15),B=y(A),X=nw.map(([z,ht])=>x(Zs(Zs(I,N,E*z),F,E*ht)));B&&X.forEach(z=>z.hidden=!0),i.beginPath(),X.forEach(({x:z,y:ht})=>i.lineTo(z,ht)),i.globalAlpha=B||x(I).hidden?.12:.3,i.fillStyle=hh,i.fill(),i.globalAlpha=1,d(X,hh,1.5)}function S(A){let E=Math.hypot(...A.pull);if(E<1e-6)return{...x(A.point),left:!1};let N=A.pull.map(it=>it/E),F=E*tw,I=n.size/110,B=Math.min(F,6*I),X=Zs(A.point,A.normal,.05),z=Array.from({length:uh+1},(it,gt)=>x(Zs(X,N,-B-(F-B)*(uh-gt)/uh))),[ht,Y,tt]=[z[0],z[uh],x(X)],rt=u/Y.far;d(z,hh,Math.max(2,2*I*rt));let Q=2.6*I*rt*(B/(6*I)),st=Math.atan2(tt.y-Y.y,tt.x-Y.x),$=[o.x-X[0],o.y-X[1],o.z-X[2]],ft=Math.abs(jm($,N))/Math.hypot(...$);return i.globalAlpha=Y.hidden||y(A)?Km:1,i.fillStyle=hh,i.beginPath(),i.ellipse(Y.x,Y.y,Math.max(Q*ft,.1),Q,st,0,2*Math.PI),i.moveTo(Y.x-Q*Math.sin(st),Y.y+Q*Math.cos(st)),i.lineTo(tt.x,tt.y),i.lineTo(Y.x+Q*Math.sin(st),Y.y-Q*Math.cos(st)),i.fill(),i.globalAlpha=1,{...ht,left:ht.x<tt.x}}function R({force:A},{x:E,y:N,left:F}){let I=`${A.toFixed(1)} N`,B=i.measureText(I).width+10,X=F?E-6-B:E+6;i.fillStyle="#ffffffd8",i.fillRect(X,N-22,B,19),i.fillStyle="#a0126f",i.fillText(I,X+5,N-8)}function M(A){let[E,N]=Qm(A.normal),F=n.size/18,I=Zs(A.point,A.normal,.25);for(let B of[E,N]){let X=[-1,-.5,0,.5,1].map(z=>x(Zs(I,B,z*F)));y(A)&&X.forEach(z=>z.hidden=!0),d(X,Qb,2)}}function _(){i.setTransform(c,0,0,c,0,0),i.clearRect(0,0,a,l),i.lineCap="butt",i.font="600 13px system-ui, sans-serif",h.forEach(P),p.forEach(M);let A=h.map(S);h.forEach((E,N)=>R(E,A[N]))}function b(A,E){[h,p]=[A,E.filter(({force:N})=>N>=ew)],_()}return{show:b,shown:()=>h,told:()=>p,hidden:()=>h.map(A=>y(A)||x(Zs(A.point,A.normal,.15)).hidden)}}function fh(){let n=[];return{note(t,e=performance.now()){n.push([e,t]),n[0][0]<e-6e4&&(n=n.filter(([i])=>i>=e-6e4))},values:()=>n.map(([,t])=>t),since:t=>n.filter(([e])=>e>=t).map(([e])=>e),forget:()=>n=[]}}function dh(n){let t=n.sort((i,s)=>i-s),e=i=>t[Math.min(t.length-1,Math.floor(i*t.length))];return{count:t.length,p50:e(.5),p90:e(.9),p99:e(.99),most:t.at(-1)}}function eg(){let[n,t,e,i]=[fh(),fh(),fh(),fh()],s={shown:0,messages:0,rows:0,dropped:0},r=()=>performance.timeOrigin+performance.now(),o=({readS:h,arrivedS:p})=>1e3*(h||p);function a(h){let{rows:p,dropped:m}=h;i.note(r()-o(h)),s.messages+=1,s.rows+=p,s.dropped=m}function l(h){s.shown+=1,e.note(h)}function c(h){n.note(r()-o(h)),t.note(r()-1e3*h.arrivedS)}function u(){let h=e.since(performance.now()-3e3),p=h.length>1?1e3*(h.length-1)/(h.at(-1)-h[0]):0;return{...s,perSecond:p,latencyMs:dh(n.values()),underwayMs:dh(i.values()),ageMs:dh(t.values()),workMs:dh(e.values())}}function f(){[n,t,e,i].forEach(h=>h.forget()),Object.assign(s,{shown:0,messages:0,rows:0})}return{came:a,drawn:l,seen:c,told:u,forget:f}}var iw=n=>String.fromCharCode(...[0,1,2,3].map(t=>n.getUint8(t)));function ng(n,t){let e=new DataView(n);if(iw(e)==="IOS1")return{state:JSON.parse(new TextDecoder().decode(new Uint8Array(n,4)))};let[i,s,r]=[e.getUint16(4,!0),e.getUint8(6),e.getUint8(7)],o=new Float32Array(n,40),a=1+t,l=(c,u,f,h)=>Array.from({length:c},(p,m)=>h(o.subarray(f+m*u,f+(m+1)*u)));return{number:e.getUint32(8,!0),dropped:e.getUint32(12,!0),arrivedS:e.getFloat64(16,!0),readS:e.getFloat64(24,!0),timeS:e.getFloat64(32,!0),rows:i,values:o,wide:a,contacts:l(s,15,i*a,([c,u,f,h,p,m,...x])=>({face:c,x:u,y:f,radius:h,force:p,halfwidth:m,point:x.slice(0,3),normal:x.slice(3,6),pull:x.slice(6,9)})),labels:l(r,10,i*a+s*15,([c,u,f,h,...p])=>({face:c,x:u,y:f,force:h,point:p.slice(0,3),normal:p.slice(3,6)}))}}var sw="uplot",rw="u-hz",ow="u-vt",aw="u-title",lw="u-wrap",cw="u-under",hw="u-over",uw="u-axis",gr="u-off",fw="u-select",dw="u-cursor-x",pw="u-cursor-y",mw="u-cursor-pt",gw="u-legend",_w="u-live",xw="u-inline",yw="u-series",vw="u-marker",ig="u-label",Sw="u-value",La="width",Da="height";var sg="bottom",go="left",yf="right",Ff="#000",rg=Ff+"0",vf="mousemove",og="mousedown",Sf="mouseup",ag="mouseenter",lg="mouseleave",cg="dblclick",Mw="resize",bw="scroll",hg="change",xh="dppxchange",Of="--",bo=typeof window<"u",Tf=bo?document:null,xo=bo?window:null,ww=bo?navigator:null,Ae,ph;function Af(){let n=devicePixelRatio;Ae!=n&&(Ae=n,ph&&Rf(hg,ph,Af),ph=matchMedia(`(min-resolution: ${Ae-.001}dppx) and (max-resolution: ${Ae+.001}dppx)`),_r(hg,ph,Af),xo.dispatchEvent(new CustomEvent(xh)))}function li(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Cf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function qe(n,t,e){n.style[t]=e+"px"}function Li(n,t,e,i){let s=Tf.createElement(n);return t!=null&&li(s,t),e?.insertBefore(s,i),s}function xi(n,t){return Li("div",n,t)}var ug=new WeakMap;function Qi(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=ug.get(n);r!=o&&(n.style.transform=r,ug.set(n,r),t<0||e<0||t>i||e>s?li(n,gr):Cf(n,gr))}var fg=new WeakMap;function dg(n,t,e){let i=t+e,s=fg.get(n);i!=s&&(fg.set(n,i),n.style.background=t,n.style.borderColor=e)}var pg=new WeakMap;function mg(n,t,e,i){let s=t+""+e,r=pg.get(n);s!=r&&(pg.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Bf={passive:!0},Ew={...Bf,capture:!0};function _r(n,t,e,i){t.addEventListener(n,e,i?Ew:Bf)}function Rf(n,t,e,i){t.removeEventListener(n,e,Bf)}bo&&Af();function Di(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ci((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Hg(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Wg=n=>n!=null,Xg=n=>n!=null&&n>0,Sh=Hg(Wg),Tw=Hg(Xg);function Aw(n,t,e,i=0,s=!1){let r=s?Tw:Sh,o=s?Xg:Wg;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Oe,l??-Oe]}function Mh(n,t,e,i){let s=xg(n),r=xg(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ms:qg,a=s==1?ci:yi,l=r==1?yi:ci,c=a(o(bn(n))),u=l(o(bn(t))),f=yo(e,c),h=yo(e,u);return e==10&&(c<0&&(f=Be(f,-c)),u<0&&(h=Be(h,-u))),i||e==2?(n=f*s,t=h*r):(n=Jg(n,f),t=bh(t,h)),[n,t]}function zf(n,t,e,i){let s=Mh(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var kf=.1,gg={mode:3,pad:kf},Ua={pad:0,soft:null,mode:0},Cw={min:Ua,max:Ua};function yh(n,t,e,i){return wh(e)?_g(n,t,e):(Ua.pad=e,Ua.soft=i?0:null,Ua.mode=i?3:0,_g(n,t,Cw))}function Me(n,t){return n??t}function Rw(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function _g(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-Oe),l=Me(s.hard,Oe),c=Me(i.soft,Oe),u=Me(s.soft,-Oe),f=Me(i.mode,0),h=Me(s.mode,0),p=t-n,m=Ms(p),x=Jn(bn(n),bn(t)),g=Ms(x),d=bn(g-m);(p<1e-24||d>10)&&(p=0,(n==0||t==0)&&(p=1e-24,f==2&&c!=Oe&&(r=0),h==2&&u!=-Oe&&(o=0)));let y=p||x||1e3,P=Ms(y),S=yo(10,ci(P)),R=y*(p==0?n==0?.1:1:r),M=Be(Jg(n-R,S/10),24),_=n>=c&&(f==1||f==3&&M<=c||f==2&&M>=c)?c:Oe,b=Jn(a,M<_&&n>=_?_:Ni(_,M)),D=y*(p==0?t==0?.1:1:o),A=Be(bh(t+D,S/10),24),E=t<=u&&(h==1||h==3&&A>=u||h==2&&A<=u)?u:-Oe,N=Ni(l,A>E&&t<=E?E:Jn(E,A));return b==N&&b==0&&(N=100),[b,N]}var Pw=new Intl.NumberFormat(bo?ww.language:"en-US"),Vf=n=>Pw.format(n),hi=Math,_h=hi.PI,bn=hi.abs,ci=hi.floor,Mn=hi.round,yi=hi.ceil,Ni=hi.min,Jn=hi.max,yo=hi.pow,xg=hi.sign,Ms=hi.log10,qg=hi.log2,Iw=(n,t=1)=>hi.sinh(n)*t,Mf=(n,t=1)=>hi.asinh(n/t),Oe=1/0;function yg(n){return(Ms((n^n>>31)-(n>>31))|0)+1}function Pf(n,t,e){return Ni(Jn(n,t),e)}function Yg(n){return typeof n=="function"}function xe(n){return Yg(n)?n:()=>n}var Lw=()=>{},$g=n=>n,Zg=(n,t)=>t,Dw=n=>null,vg=n=>!0,Sg=(n,t)=>n==t,Nw=/\.\d*?(?=9{6,}|0{6,})/gm,xr=n=>{if(jg(n)||Ks.has(n))return n;let t=`${n}`,e=t.match(Nw);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${xr(s)}e${r}`}return Be(n,i)};function pr(n,t){return xr(Be(xr(n/t))*t)}function bh(n,t){return xr(yi(xr(n/t))*t)}function Jg(n,t){return xr(ci(xr(n/t))*t)}function Be(n,t=0){if(jg(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Mn(i)/e}var Ks=new Map;function Kg(n){return((""+n).split(".")[1]||"").length}function Oa(n,t,e,i){let s=[],r=i.map(Kg);for(let o=t;o<e;o++){let a=bn(o),l=Be(yo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Be(u,f);s.push(h),Ks.set(h,f)}}return s}var Fa={},Gf=[],vo=[null,null],Js=Array.isArray,jg=Number.isInteger,Uw=n=>n===void 0;function Mg(n){return typeof n=="string"}function wh(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Fw(n){return n!=null&&typeof n=="object"}var Ow=Object.getPrototypeOf(Uint8Array),Qg="__proto__";function So(n,t=wh){let e;if(Js(n)){let i=n.find(s=>s!=null);if(Js(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=So(n[s],t)}else e=n.slice()}else if(n instanceof Ow)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Qg&&(e[i]=So(n[i],t))}else e=n;return e}function _n(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Qg&&(wh(n[s])?_n(n[s],So(i[s])):n[s]=So(i[s]))}return n}var Bw=0,zw=1,kw=2;function Vw(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function Gw(n,t){if(Xw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return qw(o[0])||(o=Ww(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=t?t[o][c]:zw,p=[];for(let m=0;m<u.length;m++){let x=u[m],g=r.get(l[m]);x===null?h!=Bw&&(f[g]=x,h==kw&&p.push(g)):f[g]=x}Vw(f,p,s),i.push(f)}}return i}var Hw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Ww(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Xw(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function qw(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,ci((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var t0=["January","February","March","April","May","June","July","August","September","October","November","December"],e0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function n0(n){return n.slice(0,3)}var Yw=e0.map(n0),$w=t0.map(n0),Zw={MMMM:t0,MMM:$w,WWWW:e0,WWW:Yw};function Ia(n){return(n<10?"0":"")+n}function Jw(n){return(n<10?"00":n<100?"0":"")+n}var Kw={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Ia(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ia(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Ia(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ia(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ia(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Jw(n.getMilliseconds())};function Hf(n,t){t=t||Zw;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Kw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var jw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Qw(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==jw?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var i0=n=>n%1==0,vh=[1,2,2.5,5],tE=Oa(10,-32,0,vh),s0=Oa(10,0,32,vh),eE=s0.filter(i0),mr=tE.concat(s0),Wf=`
`,r0="{YYYY}",bg=Wf+r0,o0="{M}/{D}",Na=Wf+o0,mh=Na+"/{YY}",a0="{aa}",nE="{h}:{mm}",_o=nE+a0,wg=Wf+_o,Eg=":{ss}",Re=null;function l0(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Oa(10,0,3,vh).filter(i0):Oa(10,-3,0,vh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,r0,Re,Re,Re,Re,Re,Re,1],[s*28,"{MMM}",bg,Re,Re,Re,Re,Re,1],[s,o0,bg,Re,Re,Re,Re,Re,1],[i,"{h}"+a0,mh,Re,Na,Re,Re,Re,1],[e,_o,mh,Re,Na,Re,Re,Re,1],[t,Eg,mh+" "+_o,Re,Na+" "+_o,Re,wg,Re,1],[n,Eg+".{fff}",mh+" "+_o,Re,Na+" "+_o,Re,wg,Re,1]];function u(f){return(h,p,m,x,g,d)=>{let y=[],P=g>=o,S=g>=r&&g<o,R=f(m),M=Be(R*n,3),_=bf(R.getFullYear(),P?0:R.getMonth(),S||P?1:R.getDate()),b=Be(_*n,3);if(S||P){let D=S?g/r:0,A=P?g/o:0,E=M==b?M:Be(bf(_.getFullYear()+A,_.getMonth()+D,1)*n,3),N=new Date(Mn(E/n)),F=N.getFullYear(),I=N.getMonth();for(let B=0;E<=x;B++){let X=bf(F+A*B,I+D*B,1),z=X-f(Be(X*n,3));E=Be((+X+z)*n,3),E<=x&&y.push(E)}}else{let D=g>=s?s:g,A=ci(m)-ci(M),E=b+A+bh(M-b,D);y.push(E);let N=f(E),F=N.getHours()+N.getMinutes()/e+N.getSeconds()/i,I=g/i,B=h.axes[p]._space,X=d/B;for(;E=Be(E+g,n==1?0:3),!(E>x);)if(I>1){let z=ci(Be(F+I,6))%24,tt=f(E).getHours()-z;tt>1&&(tt=-1),E-=tt*i,F=(F+I)%24;let rt=y[y.length-1];Be((E-rt)/g,3)*X>=.7&&y.push(E)}else y.push(E)}return y}}return[l,c,u]}var[iE,sE,rE]=l0(1),[oE,aE,lE]=l0(.001);Oa(2,-53,53,[1]);function Tg(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Ag(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,f,h,p;return i.map(m=>{let x=n(m),g=x.getFullYear(),d=x.getMonth(),y=x.getDate(),P=x.getHours(),S=x.getMinutes(),R=x.getSeconds(),M=g!=l&&a[2]||d!=c&&a[3]||y!=u&&a[4]||P!=f&&a[5]||S!=h&&a[6]||R!=p&&a[7]||a[1];return l=g,c=d,u=y,f=P,h=S,p=R,M(x)})}}function cE(n,t){let e=Hf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function bf(n,t,e){return new Date(n,t,e)}function Cg(n,t){return t(n)}var hE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Rg(n,t){return(e,i,s,r)=>r==null?Of:t(n(i))}function uE(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function fE(n,t){return n.series[t].fill(n,t)}var dE={show:!0,live:!0,isolate:!1,mount:Lw,markers:{show:!0,width:2,stroke:uE,fill:fE,dash:"solid"},idx:null,idxs:null,values:[]};function pE(n,t){let e=n.cursor.points,i=xi(),s=e.size(n,t);qe(i,La,s),qe(i,Da,s);let r=s/-2;qe(i,"marginLeft",r),qe(i,"marginTop",r);let o=e.width(n,t,s);return o&&qe(i,"borderWidth",o),i}function mE(n,t){let e=n.series[t].points;return e._fill||e._stroke}function gE(n,t){let e=n.series[t].points;return e._stroke||e._fill}function _E(n,t){return n.series[t].points.size}var wf=[0,0];function xE(n,t,e){return wf[0]=t,wf[1]=e,wf}function gh(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Ef(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var yE={show:!0,x:!0,y:!0,lock:!1,move:xE,points:{one:!1,show:pE,size:_E,width:0,stroke:gE,fill:mE},bind:{mousedown:gh,mouseup:gh,click:gh,dblclick:gh,mousemove:Ef,mouseleave:Ef,mouseenter:Ef},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},c0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xf=_n({},c0,{filter:Zg}),h0=_n({},Xf,{size:10}),u0=_n({},c0,{show:!1}),qf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',f0="bold "+qf,d0=1.5,Pg={show:!0,scale:"x",stroke:Ff,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:f0,side:2,grid:Xf,ticks:h0,border:u0,font:qf,lineGap:d0,rotate:0},vE="Value",SE="Time",Ig={show:!0,scale:"x",auto:!1,sorted:1,min:Oe,max:-Oe,idxs:[]};function ME(n,t,e,i,s){return t.map(r=>r==null?"":Vf(r))}function bE(n,t,e,i,s,r,o){let a=[],l=Ks.get(s)||0;e=o?e:Be(bh(e,s),l);for(let c=e;c<=i;c=Be(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function If(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ms:qg,u=ci(c(e));s=yo(l,u),l==10&&(s=mr[Di(s,mr)]);let f=e,h=s*l;l==10&&(h=mr[Di(h,mr)]);do a.push(f),f=f+s,l==10&&!Ks.has(f)&&(f=Be(f,Ks.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=mr[Di(h,mr)]));while(f<=i);return a}function wE(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?If(n,t,Jn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?If(n,t,Jn(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var p0=/./,EE=/[12357]/,TE=/[125]/,Lg=/1/,Lf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function AE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?p0:l(7,o)-u>=c?EE:l(5,o)-u>=c?TE:Lg;if(f==Lg){let h=bn(l(1,o)-u);if(h<c)return Lf(t.slice().reverse(),a.distr,f,yi(c/h)).reverse()}return Lf(t,a.distr,f,1)}function CE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=bn(l(1,o)-l(2,o));return c<a?Lf(t.slice().reverse(),3,p0,yi(a/c)).reverse():t}function RE(n,t,e,i){return i==null?Of:t==null?"":Vf(t)}var Dg={show:!0,scale:"y",stroke:Ff,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:f0,side:3,grid:Xf,ticks:h0,border:u0,font:qf,lineGap:d0,rotate:0};function PE(n,t){let e=3+(n||1)*2;return Be(e*t,3)}function IE(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=bn(o-r),l=n.series[t],c=a/(l.points.space*Ae);return i[1]-i[0]<=c}var Ng={scale:null,auto:!0,sorted:0,min:Oe,max:-Oe},m0=(n,t,e,i,s)=>s,Ug={show:!0,auto:!0,sorted:0,gaps:m0,alpha:1,facets:[_n({},Ng,{scale:"x"}),_n({},Ng,{scale:"y"})]},Fg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:m0,alpha:1,points:{show:IE,filter:null},values:null,min:Oe,max:-Oe,idxs:[],path:null,clip:null};function LE(n,t,e,i,s){return e/10}var g0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},DE=_n({},g0,{time:!1,ori:1}),Og={};function _0(n,t){let e=Og[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Og[n]=e)),e}var Mo=1,Df=2;function yr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,p=a.top,m=a.width,x=a.height,g=n.valToPosH,d=n.valToPosV;return u.ori==0?e(s,l,c,u,f,g,d,h,p,m,x,Th,wo,Ch,y0,S0):e(s,l,c,u,f,d,g,p,h,x,m,Ah,Eo,Zf,v0,M0)}function Yf(n,t){let e=0,i=0,s=Me(n.bands,Gf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function NE(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,t,e,i,s,r){return yr(n,t,(o,a,l,c,u,f,h,p,m,x,g)=>{let d=o.pxRound,y=c.dir*(c.ori==0?1:-1),P=c.ori==0?wo:Eo,S,R;y==1?(S=e,R=i):(S=i,R=e);let M=d(f(a[S],c,x,p)),_=d(h(l[S],u,g,m)),b=d(f(a[R],c,x,p)),D=d(h(r==1?u.max:u.min,u,g,m)),A=new Path2D(s);return P(A,b,D),P(A,M,D),P(A,M,_),A})}function Eh(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Ch:Zf,l=e;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let p=h[0]-l;p>0&&a(o,l,i,p,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function UE(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function $f(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let p=r(n[f]),m=h==f?p:r(n[h]),x=f-s;p=o<=0&&x>=0&&x<l?r(n[x]):p;let d=h+s;m=o>=0&&d>=0&&d<l?r(n[d]):m,m>=p&&a.push([p,m])}return a}function Bg(n){return n==0?$g:n==1?Mn:t=>pr(t,n)}function x0(n){let t=n==0?Th:Ah,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),u=Ni(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Th=(n,t,e)=>{n.moveTo(t,e)},Ah=(n,t,e)=>{n.moveTo(e,t)},wo=(n,t,e)=>{n.lineTo(t,e)},Eo=(n,t,e)=>{n.lineTo(e,t)},Ch=x0(0),Zf=x0(1),y0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},v0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},S0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},M0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function b0(n){return(t,e,i,s,r)=>yr(t,e,(o,a,l,c,u,f,h,p,m,x,g)=>{let{pxRound:d,points:y}=o,P,S;c.ori==0?(P=Th,S=y0):(P=Ah,S=v0);let R=Be(y.width*Ae,3),M=(y.size-y.width)/2*Ae,_=Be(M*2,3),b=new Path2D,D=new Path2D,{left:A,top:E,width:N,height:F}=t.bbox;Ch(D,A-_,E-_,N+_*2,F+_*2);let I=B=>{if(l[B]!=null){let X=d(f(a[B],c,x,p)),z=d(h(l[B],u,g,m));P(b,X+M,z),S(b,X,z,M,0,_h*2)}};if(r)r.forEach(I);else for(let B=i;B<=s;B++)I(B);return{stroke:R>0?b:null,fill:b,clip:D,flags:Mo|Df}})}function w0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var FE=w0(wo),OE=w0(Eo);function E0(n){let t=Me(n?.alignGaps,0);return(e,i,s,r)=>yr(e,i,(o,a,l,c,u,f,h,p,m,x,g)=>{[s,r]=Sh(l,s,r);let d=o.pxRound,y=F=>d(f(F,c,x,p)),P=F=>d(h(F,u,g,m)),S,R;c.ori==0?(S=wo,R=FE):(S=Eo,R=OE);let M=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},b=_.stroke,D=!1;if(r-s>=x*4){let F=st=>e.posToVal(st,c.key,!0),I=null,B=null,X,z,ht,Y=y(a[M==1?s:r]),tt=y(a[s]),rt=y(a[r]),Q=F(M==1?tt+1:rt-1);for(let st=M==1?s:r;st>=s&&st<=r;st+=M){let $=a[st],it=(M==1?$<Q:$>Q)?Y:y($),gt=l[st];it==Y?gt!=null?(z=gt,I==null?(S(b,it,P(z)),X=I=B=z):z<I?I=z:z>B&&(B=z)):gt===null&&(D=!0):(I!=null&&R(b,Y,P(I),P(B),P(X),P(z)),gt!=null?(z=gt,S(b,it,P(z)),I=B=X=z):(I=B=null,gt===null&&(D=!0)),Y=it,Q=F(Y+M))}I!=null&&I!=B&&ht!=Y&&R(b,Y,P(I),P(B),P(X),P(z))}else for(let F=M==1?s:r;F>=s&&F<=r;F+=M){let I=l[F];I===null?D=!0:I!=null&&S(b,y(a[F]),P(I))}let[E,N]=Yf(e,i);if(o.fill!=null||E!=0){let F=_.fill=new Path2D(b),I=o.fillTo(e,i,o.min,o.max,E),B=P(I),X=y(a[s]),z=y(a[r]);M==-1&&([z,X]=[X,z]),S(F,z,B),S(F,X,B)}if(!o.spanGaps){let F=[];D&&F.push(...$f(a,l,s,r,M,y,t)),_.gaps=F=o.gaps(e,i,s,r,F),_.clip=Eh(F,c.ori,p,m,x,g)}return N!=0&&(_.band=N==2?[bs(e,i,s,r,b,-1),bs(e,i,s,r,b,1)]:bs(e,i,s,r,b,N)),_})}function BE(n){let t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,l)=>yr(r,o,(c,u,f,h,p,m,x,g,d,y,P)=>{[a,l]=Sh(f,a,l);let S=c.pxRound,{left:R,width:M}=r.bbox,_=tt=>S(m(tt,h,y,g)),b=tt=>S(x(tt,p,P,d)),D=h.ori==0?wo:Eo,A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},E=A.stroke,N=h.dir*(h.ori==0?1:-1),F=b(f[N==1?a:l]),I=_(u[N==1?a:l]),B=I,X=I;s&&t==-1&&(X=R,D(E,X,F)),D(E,I,F);for(let tt=N==1?a:l;tt>=a&&tt<=l;tt+=N){let rt=f[tt];if(rt==null)continue;let Q=_(u[tt]),st=b(rt);t==1?D(E,Q,F):D(E,B,st),D(E,Q,st),F=st,B=Q}let z=B;s&&t==1&&(z=R+M,D(E,z,F));let[ht,Y]=Yf(r,o);if(c.fill!=null||ht!=0){let tt=A.fill=new Path2D(E),rt=c.fillTo(r,o,c.min,c.max,ht),Q=b(rt);D(tt,z,Q),D(tt,X,Q)}if(!c.spanGaps){let tt=[];tt.push(...$f(u,f,a,l,N,_,i));let rt=c.width*Ae/2,Q=e||t==1?rt:-rt,st=e||t==-1?-rt:rt;tt.forEach($=>{$[0]+=Q,$[1]+=st}),A.gaps=tt=c.gaps(r,o,a,l,tt),A.clip=Eh(tt,h.ori,g,d,y,P)}return Y!=0&&(A.band=Y==2?[bs(r,o,a,l,E,-1),bs(r,o,a,l,E,1)]:bs(r,o,a,l,E,Y)),A})}function zg(n,t,e,i,s,r,o=Oe){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=bn(n[l]-n[a]);u<c&&(c=u,o=bn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function zE(n){n=n||Fa;let t=Me(n.size,[.6,Oe,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xe(s),o=1-t[0],a=Me(t[1],Oe),l=Me(t[2],1),c=Me(n.disp,Fa),u=Me(n.each,p=>{}),{fill:f,stroke:h}=c;return(p,m,x,g)=>yr(p,m,(d,y,P,S,R,M,_,b,D,A,E)=>{let N=d.pxRound,F=e,I=i*Ae,B=a*Ae,X=l*Ae,z,ht;S.ori==0?[z,ht]=r(p,m):[ht,z]=r(p,m);let Y=S.dir*(S.ori==0?1:-1),tt=S.ori==0?Ch:Zf,rt=S.ori==0?u:(It,Kt,oe,Tt,Ue,Wt,Zt)=>{u(It,Kt,oe,Ue,Tt,Zt,Wt)},Q=Me(p.bands,Gf).find(It=>It.series[0]==m),st=Q!=null?Q.dir:0,$=d.fillTo(p,m,d.min,d.max,st),ft=N(_($,R,E,D)),it,gt,mt,W=A,nt=N(d.width*Ae),lt=!1,Dt=null,Ot=null,Xt=null,he=null;f!=null&&(nt==0||h!=null)&&(lt=!0,Dt=f.values(p,m,x,g),Ot=new Map,new Set(Dt).forEach(It=>{It!=null&&Ot.set(It,new Path2D)}),nt>0&&(Xt=h.values(p,m,x,g),he=new Map,new Set(Xt).forEach(It=>{It!=null&&he.set(It,new Path2D)})));let{x0:ye,size:ze}=c;if(ye!=null&&ze!=null){F=1,y=ye.values(p,m,x,g),ye.unit==2&&(y=y.map(oe=>p.posToVal(b+oe*A,S.key,!0)));let It=ze.values(p,m,x,g);ze.unit==2?gt=It[0]*A:gt=M(It[0],S,A,b)-M(0,S,A,b),W=zg(y,P,M,S,A,b,W),mt=W-gt+I}else W=zg(y,P,M,S,A,b,W),mt=W*o+I,gt=W-mt;mt<1&&(mt=0),nt>=gt/2&&(nt=0),mt<5&&(N=$g);let ve=mt>0,Ke=W-mt-(ve?nt:0);gt=N(Pf(Ke,X,B)),it=(F==0?gt/2:F==Y?0:gt)-F*Y*((F==0?I/2:0)+(ve?nt/2:0));let me={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},sn=lt?null:new Path2D,Ne=null;if(Q!=null)Ne=p.data[Q.series[1]];else{let{y0:It,y1:Kt}=c;It!=null&&Kt!=null&&(P=Kt.values(p,m,x,g),Ne=It.values(p,m,x,g))}let je=z*gt,V=ht*gt;for(let It=Y==1?x:g;It>=x&&It<=g;It+=Y){let Kt=P[It];if(Kt==null)continue;if(Ne!=null){let Z=Ne[It]??0;if(Kt-Z==0)continue;ft=_(Z,R,E,D)}let oe=S.distr!=2||c!=null?y[It]:It,Tt=M(oe,S,A,b),Ue=_(Me(Kt,$),R,E,D),Wt=N(Tt-it),Zt=N(Jn(Ue,ft)),L=N(Ni(Ue,ft)),w=Zt-L;if(Kt!=null){let Z=Kt<0?V:je,xt=Kt<0?je:V;lt?(nt>0&&Xt[It]!=null&&tt(he.get(Xt[It]),Wt,L+ci(nt/2),gt,Jn(0,w-nt),Z,xt),Dt[It]!=null&&tt(Ot.get(Dt[It]),Wt,L+ci(nt/2),gt,Jn(0,w-nt),Z,xt)):tt(sn,Wt,L+ci(nt/2),gt,Jn(0,w-nt),Z,xt),rt(p,m,It,Wt-nt/2,L,gt+nt,w)}}return nt>0?me.stroke=lt?he:sn:lt||(me._fill=d.width==0?d._fill:d._stroke??d._fill,me.width=0),me.fill=lt?Ot:sn,me})}function kE(n,t){let e=Me(t?.alignGaps,0);return(i,s,r,o)=>yr(i,s,(a,l,c,u,f,h,p,m,x,g,d)=>{[r,o]=Sh(c,r,o);let y=a.pxRound,P=z=>y(h(z,u,g,m)),S=z=>y(p(z,f,d,x)),R,M,_;u.ori==0?(R=Th,_=wo,M=S0):(R=Ah,_=Eo,M=M0);let b=u.dir*(u.ori==0?1:-1),D=P(l[b==1?r:o]),A=D,E=[],N=[];for(let z=b==1?r:o;z>=r&&z<=o;z+=b)if(c[z]!=null){let Y=l[z],tt=P(Y);E.push(A=tt),N.push(S(c[z]))}let F={stroke:n(E,N,R,_,M,y),fill:null,clip:null,band:null,gaps:null,flags:Mo},I=F.stroke,[B,X]=Yf(i,s);if(a.fill!=null||B!=0){let z=F.fill=new Path2D(I),ht=a.fillTo(i,s,a.min,a.max,B),Y=S(ht);_(z,A,Y),_(z,D,Y)}if(!a.spanGaps){let z=[];z.push(...$f(l,c,r,o,b,P,e)),F.gaps=z=a.gaps(i,s,r,o,z),F.clip=Eh(z,u.ori,m,x,g,d)}return X!=0&&(F.band=X==2?[bs(i,s,r,o,I,-1),bs(i,s,r,o,I,1)]:bs(i,s,r,o,I,X)),F})}function VE(n){return kE(GE,n)}function GE(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,t[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,t[h+1]-l[h+1]*f[h]/3,n[h+1],t[h+1])}return a}var Nf=new Set;function kg(){for(let n of Nf)n.syncRect(!0)}bo&&(_r(Mw,xo,kg),_r(bw,xo,kg,!0),_r(xh,xo,()=>{Fn.pxRatio=Ae}));var HE=E0(),WE=b0();function Vg(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Uf(r,o,t,e))}function XE(n,t){return n.map((e,i)=>i==0?{}:_n({},t,e))}function Uf(n,t,e,i){return _n({},t==0?e:i,n)}function T0(n,t,e){return t==null?vo:[t,e]}var qE=T0;function YE(n,t,e){return t==null?vo:yh(t,e,kf,!0)}function A0(n,t,e,i){return t==null?vo:Mh(t,e,n.scales[i].log,!1)}var $E=A0;function C0(n,t,e,i){return t==null?vo:zf(t,e,n.scales[i].log,!1)}var ZE=C0;function JE(n,t,e,i,s){let r=Jn(yg(n),yg(t)),o=t-n,a=Di(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Ks.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Gg(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Mn((e=+s)*Ae))+"px"),[n,t,e]}function KE(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Be(t[2]*Ae,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Fn(n,t,e){let i={mode:Me(n.mode,1)},s=i.mode;function r(v,T,U,O){let q=T.valToPct(v);return O+U*(T.dir==-1?1-q:q)}function o(v,T,U,O){let q=T.valToPct(v);return O+U*(T.dir==-1?q:1-q)}function a(v,T,U,O){return T.ori==0?r(v,T,U,O):o(v,T,U,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=xi(sw);if(n.id!=null&&(c.id=n.id),li(c,n.class),n.title){let v=xi(aw,c);v.textContent=n.title}let u=Li("canvas"),f=i.ctx=u.getContext("2d"),h=xi(lw,c);_r("click",h,v=>{v.target===m&&(Ve!=Tr||Ye!=Ar)&&Pn.click(i,v)},!0);let p=i.under=xi(cw,h);h.appendChild(u);let m=i.over=xi(hw,h);n=So(n);let x=+Me(n.pxAlign,1),g=Bg(x);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let d=n.ms||.001,y=i.series=s==1?Vg(n.series||[],Ig,Fg,!1):XE(n.series||[null],Ug),P=i.axes=Vg(n.axes||[],Pg,Dg,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(v=>{v.fill=xe(v.fill||null),v.dir=Me(v.dir,-1)});let M=s==2?y[1].facets[0].scale:y[0].scale,_={axes:is,series:fe},b=(n.drawOrder||["axes","series"]).map(v=>_[v]);function D(v){let T=v.distr==3?U=>Ms(U>0?U:v.clamp(i,U,v.min,v.max,v.key)):v.distr==4?U=>Mf(U,v.asinh):v.distr==100?U=>v.fwd(U):U=>U;return U=>{let O=T(U),{_min:q,_max:j}=v,pt=j-q;return(O-q)/pt}}function A(v){let T=S[v];if(T==null){let U=(n.scales||Fa)[v]||Fa;if(U.from!=null){A(U.from);let O=_n({},S[U.from],U,{key:v});O.valToPct=D(O),S[v]=O}else{T=S[v]=_n({},v==M?g0:DE,U),T.key=v;let O=T.time,q=T.range,j=Js(q);if((v!=M||s==2&&!O)&&(j&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?gg:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?gg:{mode:1,hard:q[1],soft:q[1]}},j=!1),!j&&wh(q))){let pt=q;q=(yt,wt,Ft)=>wt==null?vo:yh(wt,Ft,pt)}T.range=xe(q||(O?qE:v==M?T.distr==3?$E:T.distr==4?ZE:T0:T.distr==3?A0:T.distr==4?C0:YE)),T.auto=xe(j?!1:T.auto),T.clamp=xe(T.clamp||LE),T._min=T._max=null,T.valToPct=D(T)}}}A("x"),A("y"),s==1&&y.forEach(v=>{A(v.scale)}),P.forEach(v=>{A(v.scale)});for(let v in n.scales)A(v);let E=S[M],N=E.distr,F,I;E.ori==0?(li(c,rw),F=r,I=o):(li(c,ow),F=o,I=r);let B={};for(let v in S){let T=S[v];(T.min!=null||T.max!=null)&&(B[v]={min:T.min,max:T.max},T.min=T.max=null)}let X=n.tzDate||(v=>new Date(Mn(v/d))),z=n.fmtDate||Hf,ht=d==1?rE(X):lE(X),Y=Ag(X,Tg(d==1?sE:aE,z)),tt=Rg(X,Cg(hE,z)),rt=[],Q=i.legend=_n({},dE,n.legend),st=i.cursor=_n({},yE,{drag:{y:s==2}},n.cursor),$=Q.show,ft=st.show,it=Q.markers;Q.idxs=rt,it.width=xe(it.width),it.dash=xe(it.dash),it.stroke=xe(it.stroke),it.fill=xe(it.fill);let gt,mt,W,nt=[],lt=[],Dt,Ot=!1,Xt={};if(Q.live){let v=y[1]?y[1].values:null;Ot=v!=null,Dt=Ot?v(i,1,0):{_:0};for(let T in Dt)Xt[T]=Of}if($)if(gt=Li("table",gw,c),W=Li("tbody",null,gt),Q.mount(i,gt),Ot){mt=Li("thead",null,gt,W);let v=Li("tr",null,mt);Li("th",null,v);for(var he in Dt)Li("th",ig,v).textContent=he}else li(gt,xw),Q.live&&li(gt,_w);let ye={show:!0},ze={show:!1};function ve(v,T){if(T==0&&(Ot||!Q.live||s==2))return vo;let U=[],O=Li("tr",yw,W,W.childNodes[T]);li(O,v.class),v.show||li(O,gr);let q=Li("th",null,O);if(it.show){let yt=xi(vw,q);if(T>0){let wt=it.width(i,T);wt&&(yt.style.border=wt+"px "+it.dash(i,T)+" "+it.stroke(i,T)),yt.style.background=it.fill(i,T)}}let j=xi(ig,q);v.label instanceof HTMLElement?j.appendChild(v.label):j.textContent=v.label,T>0&&(it.show||(j.style.color=v.width>0?it.stroke(i,T):it.fill(i,T)),me("click",q,yt=>{if(st._lock)return;te(yt);let wt=y.indexOf(v);if((yt.ctrlKey||yt.metaKey)!=Q.isolate){let Ft=y.some((Bt,kt)=>kt>0&&kt!=wt&&Bt.show);y.forEach((Bt,kt)=>{kt>0&&zi(kt,Ft?kt==wt?ye:ze:ye,!0,un.setSeries)})}else zi(wt,{show:!v.show},!0,un.setSeries)},!1),ee&&me(ag,q,yt=>{st._lock||(te(yt),zi(y.indexOf(v),Rr,!0,un.setSeries))},!1));for(var pt in Dt){let yt=Li("td",Sw,O);yt.textContent="--",U.push(yt)}return[O,U]}let Ke=new Map;function me(v,T,U,O=!0){let q=Ke.get(T)||{},j=st.bind[v](i,T,U,O);j&&(_r(v,T,q[v]=j),Ke.set(T,q))}function sn(v,T,U){let O=Ke.get(T)||{};for(let q in O)(v==null||q==v)&&(Rf(q,T,O[q]),delete O[q]);v==null&&Ke.delete(T)}let Ne=0,je=0,V=0,It=0,Kt=0,oe=0,Tt=Kt,Ue=oe,Wt=V,Zt=It,L=0,w=0,Z=0,xt=0;i.bbox={};let dt=!1,Mt=!1,bt=!1,ot=!1,ct=!1,vt=!1;function k(v,T,U){(U||v!=i.width||T!=i.height)&&ut(v,T),le(!1),bt=!0,Mt=!0,On()}function ut(v,T){i.width=Ne=V=v,i.height=je=It=T,Kt=oe=0,Et(),qt();let U=i.bbox;L=U.left=pr(Kt*Ae,.5),w=U.top=pr(oe*Ae,.5),Z=U.width=pr(V*Ae,.5),xt=U.height=pr(It*Ae,.5)}let at=3;function At(){let v=!1,T=0;for(;!v;){T++;let U=br(T),O=Bi(T);v=T==at||U&&O,v||(ut(i.width,i.height),Mt=!0)}}function St({width:v,height:T}){k(v,T)}i.setSize=St;function Et(){let v=!1,T=!1,U=!1,O=!1;P.forEach((q,j)=>{if(q.show&&q._show){let{side:pt,_size:yt}=q,wt=pt%2,Ft=q.label!=null?q.labelSize:0,Bt=yt+Ft;Bt>0&&(wt?(V-=Bt,pt==3?(Kt+=Bt,O=!0):U=!0):(It-=Bt,pt==0?(oe+=Bt,v=!0):T=!0))}}),Fi[0]=v,Fi[1]=U,Fi[2]=T,Fi[3]=O,V-=vi[1]+vi[3],Kt+=vi[3],It-=vi[2]+vi[0],oe+=vi[0]}function qt(){let v=Kt+V,T=oe+It,U=Kt,O=oe;function q(j,pt){switch(j){case 1:return v+=pt,v-pt;case 2:return T+=pt,T-pt;case 3:return U-=pt,U+pt;case 0:return O-=pt,O+pt}}P.forEach((j,pt)=>{if(j.show&&j._show){let yt=j.side;j._pos=q(yt,j._size),j.label!=null&&(j._lpos=q(yt,j.labelSize))}})}if(st.dataIdx==null){let v=st.hover,T=v.skip=new Set(v.skip??[]);T.add(void 0);let U=v.prox=xe(v.prox),O=v.bias??=0;st.dataIdx=(q,j,pt,yt)=>{if(j==0)return pt;let wt=pt,Ft=U(q,j,pt,yt)??Oe,Bt=Ft>=0&&Ft<Oe,kt=E.ori==0?V:It,se=st.left,be=t[0],Se=t[j];if(T.has(Se[pt])){wt=null;let pe=null,jt=null,$t;if(O==0||O==-1)for($t=pt;pe==null&&$t-- >0;)T.has(Se[$t])||(pe=$t);if(O==0||O==1)for($t=pt;jt==null&&$t++<Se.length;)T.has(Se[$t])||(jt=$t);if(pe!=null||jt!=null)if(Bt){let He=pe==null?-1/0:F(be[pe],E,kt,0),en=jt==null?1/0:F(be[jt],E,kt,0),An=se-He,De=en-se;An<=De?An<=Ft&&(wt=pe):De<=Ft&&(wt=jt)}else wt=jt==null?pe:pe==null?jt:pt-pe<=jt-pt?pe:jt}else Bt&&bn(se-F(be[pt],E,kt,0))>Ft&&(wt=null);return wt}}let te=v=>{st.event=v};st.idxs=rt,st._lock=!1;let _t=st.points;_t.show=xe(_t.show),_t.size=xe(_t.size),_t.stroke=xe(_t.stroke),_t.width=xe(_t.width),_t.fill=xe(_t.fill);let Vt=i.focus=_n({},n.focus||{alpha:.3},st.focus),ee=Vt.prox>=0,Pt=ee&&_t.one,ae=[],ke=[],Gn=[];function To(v,T){let U=_t.show(i,T);if(U instanceof HTMLElement)return li(U,mw),li(U,v.class),Qi(U,-10,-10,V,It),m.insertBefore(U,ae[T]),U}function vr(v,T){if(s==1||T>0){let U=s==1&&S[v.scale].time,O=v.value;v.value=U?Mg(O)?Rg(X,Cg(O,z)):O||tt:O||RE,v.label=v.label||(U?SE:vE)}if(Pt||T>0){v.width=v.width==null?1:v.width,v.paths=v.paths||HE||Dw,v.fillTo=xe(v.fillTo||NE),v.pxAlign=+Me(v.pxAlign,x),v.pxRound=Bg(v.pxAlign),v.stroke=xe(v.stroke||null),v.fill=xe(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let U=PE(Jn(1,v.width),1),O=v.points=_n({},{size:U,width:Jn(1,U*.2),stroke:v.stroke,space:U*2,paths:WE,_stroke:null,_fill:null},v.points);O.show=xe(O.show),O.filter=xe(O.filter),O.fill=xe(O.fill),O.stroke=xe(O.stroke),O.paths=xe(O.paths),O.pxAlign=v.pxAlign}if($){let U=ve(v,T);nt.splice(T,0,U[0]),lt.splice(T,0,U[1]),Q.values.push(null)}if(ft){rt.splice(T,0,null);let U=null;Pt?T==0&&(U=To(v,T)):T>0&&(U=To(v,T)),ae.splice(T,0,U),ke.splice(T,0,0),Gn.splice(T,0,0)}Tn("addSeries",T)}function Rh(v,T){T=T??y.length,v=s==1?Uf(v,T,Ig,Fg):Uf(v,T,{},Ug),y.splice(T,0,v),vr(y[T],T)}i.addSeries=Rh;function Ba(v){if(y.splice(v,1),$){Q.values.splice(v,1),lt.splice(v,1);let T=nt.splice(v,1)[0];sn(null,T.firstChild),T.remove()}ft&&(rt.splice(v,1),ae.splice(v,1)[0].remove(),ke.splice(v,1),Gn.splice(v,1)),Tn("delSeries",v)}i.delSeries=Ba;let Fi=[!1,!1,!1,!1];function ts(v,T){if(v._show=v.show,v.show){let U=v.side%2,O=S[v.scale];O==null&&(v.scale=U?y[1].scale:M,O=S[v.scale]);let q=O.time;v.size=xe(v.size),v.space=xe(v.space),v.rotate=xe(v.rotate),Js(v.incrs)&&v.incrs.forEach(pt=>{!Ks.has(pt)&&Ks.set(pt,Kg(pt))}),v.incrs=xe(v.incrs||(O.distr==2?eE:q?d==1?iE:oE:mr)),v.splits=xe(v.splits||(q&&O.distr==1?ht:O.distr==3?If:O.distr==4?wE:bE)),v.stroke=xe(v.stroke),v.grid.stroke=xe(v.grid.stroke),v.ticks.stroke=xe(v.ticks.stroke),v.border.stroke=xe(v.border.stroke);let j=v.values;v.values=Js(j)&&!Js(j[0])?xe(j):q?Js(j)?Ag(X,Tg(j,z)):Mg(j)?cE(X,j):j||Y:j||ME,v.filter=xe(v.filter||(O.distr>=3&&O.log==10?AE:O.distr==3&&O.log==2?CE:Zg)),v.font=Gg(v.font),v.labelFont=Gg(v.labelFont),v._size=v.size(i,null,T,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Fi[T]=!0,v._el=xi(uw,h))}}function es(v,T,U,O){let[q,j,pt,yt]=U,wt=T%2,Ft=0;return wt==0&&(yt||j)&&(Ft=T==0&&!q||T==2&&!pt?Mn(Pg.size/3):0),wt==1&&(q||pt)&&(Ft=T==1&&!j||T==3&&!yt?Mn(Dg.size/2):0),Ft}let Ao=i.padding=(n.padding||[es,es,es,es]).map(v=>xe(Me(v,es))),vi=i._padding=Ao.map((v,T)=>v(i,T,Fi,0)),Qe,rn=null,on=null,Oi=s==1?y[0].idxs:null,ti=null,Es=!1;function Co(v,T){if(t=v??[],i.data=i._data=t,s==2){Qe=0;for(let U=1;U<y.length;U++)Qe+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ti=t[0],Qe=ti.length;let U=t;if(N==2){U=t.slice();let O=U[0]=Array(Qe);for(let q=0;q<Qe;q++)O[q]=q}i._data=t=U}if(le(!0),Tn("setData"),N==2&&(bt=!0),T!==!1){let U=E;U.auto(i,Es)?Ro():Cs(M,U.min,U.max),ot=ot||st.left>=0,vt=!0,On()}}i.setData=Co;function Ro(){Es=!0;let v,T;s==1&&(Qe>0?(rn=Oi[0]=0,on=Oi[1]=Qe-1,v=t[0][rn],T=t[0][on],N==2?(v=rn,T=on):v==T&&(N==3?[v,T]=Mh(v,v,E.log,!1):N==4?[v,T]=zf(v,v,E.log,!1):E.time?T=v+Mn(86400/d):[v,T]=yh(v,T,kf,!0))):(rn=Oi[0]=v=null,on=Oi[1]=T=null)),Cs(M,v,T)}let Sr,Ts,Mr,C,H,et,J,K,Ct,Lt;function Rt(v,T,U,O,q,j){v??=rg,U??=Gf,O??="butt",q??=rg,j??="round",v!=Sr&&(f.strokeStyle=Sr=v),q!=Ts&&(f.fillStyle=Ts=q),T!=Mr&&(f.lineWidth=Mr=T),j!=H&&(f.lineJoin=H=j),O!=et&&(f.lineCap=et=O),U!=C&&f.setLineDash(C=U)}function Nt(v,T,U,O){T!=Ts&&(f.fillStyle=Ts=T),v!=J&&(f.font=J=v),U!=K&&(f.textAlign=K=U),O!=Ct&&(f.textBaseline=Ct=O)}function Ht(v,T,U,O,q=0){if(O.length>0&&v.auto(i,Es)&&(T==null||T.min==null)){let j=Me(rn,0),pt=Me(on,O.length-1),yt=U.min==null?Aw(O,j,pt,q,v.distr==3):[U.min,U.max];v.min=Ni(v.min,U.min=yt[0]),v.max=Jn(v.max,U.max=yt[1])}}let ne={min:null,max:null};function ue(){for(let O in S){let q=S[O];B[O]==null&&(q.min==null||B[M]!=null&&q.auto(i,Es))&&(B[O]=ne)}for(let O in S){let q=S[O];B[O]==null&&q.from!=null&&B[q.from]!=null&&(B[O]=ne)}B[M]!=null&&le(!0);let v={};for(let O in B){let q=B[O];if(q!=null){let j=v[O]=So(S[O],Fw);if(q.min!=null)_n(j,q);else if(O!=M||s==2)if(Qe==0&&j.from==null){let pt=j.range(i,null,null,O);j.min=pt[0],j.max=pt[1]}else j.min=Oe,j.max=-Oe}}if(Qe>0){y.forEach((O,q)=>{if(s==1){let j=O.scale,pt=B[j];if(pt==null)return;let yt=v[j];if(q==0){let wt=yt.range(i,yt.min,yt.max,j);yt.min=wt[0],yt.max=wt[1],rn=Di(yt.min,t[0]),on=Di(yt.max,t[0]),on-rn>1&&(t[0][rn]<yt.min&&rn++,t[0][on]>yt.max&&on--),O.min=ti[rn],O.max=ti[on]}else O.show&&O.auto&&Ht(yt,pt,O,t[q],O.sorted);O.idxs[0]=rn,O.idxs[1]=on}else if(q>0&&O.show&&O.auto){let[j,pt]=O.facets,yt=j.scale,wt=pt.scale,[Ft,Bt]=t[q],kt=v[yt],se=v[wt];kt!=null&&Ht(kt,B[yt],j,Ft,j.sorted),se!=null&&Ht(se,B[wt],pt,Bt,pt.sorted),O.min=pt.min,O.max=pt.max}});for(let O in v){let q=v[O],j=B[O];if(q.from==null&&(j==null||j.min==null)){let pt=q.range(i,q.min==Oe?null:q.min,q.max==-Oe?null:q.max,O);q.min=pt[0],q.max=pt[1]}}}for(let O in v){let q=v[O];if(q.from!=null){let j=v[q.from];if(j.min==null)q.min=q.max=null;else{let pt=q.range(i,j.min,j.max,O);q.min=pt[0],q.max=pt[1]}}}let T={},U=!1;for(let O in v){let q=v[O],j=S[O];if(j.min!=q.min||j.max!=q.max){j.min=q.min,j.max=q.max;let pt=j.distr;j._min=pt==3?Ms(j.min):pt==4?Mf(j.min,j.asinh):pt==100?j.fwd(j.min):j.min,j._max=pt==3?Ms(j.max):pt==4?Mf(j.max,j.asinh):pt==100?j.fwd(j.max):j.max,T[O]=U=!0}}if(U){y.forEach((O,q)=>{s==2?q>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)bt=!0,Tn("setScale",O);ft&&st.left>=0&&(ot=vt=!0)}for(let O in B)B[O]=null}function Gt(v){let T=Pf(rn-1,0,Qe-1),U=Pf(on+1,0,Qe-1);for(;v[T]==null&&T>0;)T--;for(;v[U]==null&&U<Qe-1;)U++;return[T,U]}function fe(){if(Qe>0){let v=y.some(T=>T._focus)&&Lt!=Vt.alpha;v&&(f.globalAlpha=Lt=Vt.alpha),y.forEach((T,U)=>{if(U>0&&T.show&&(Je(U,!1),Je(U,!0),T._paths==null)){let O=Lt;Lt!=T.alpha&&(f.globalAlpha=Lt=T.alpha);let q=s==2?[0,t[U][0].length-1]:Gt(t[U]);T._paths=T.paths(i,U,q[0],q[1]),Lt!=O&&(f.globalAlpha=Lt=O)}}),y.forEach((T,U)=>{if(U>0&&T.show){let O=Lt;Lt!=T.alpha&&(f.globalAlpha=Lt=T.alpha),T._paths!=null&&Pe(U,!1);{let q=T._paths!=null?T._paths.gaps:null,j=T.points.show(i,U,rn,on,q),pt=T.points.filter(i,U,j,q);(j||pt)&&(T.points._paths=T.points.paths(i,U,rn,on,pt),Pe(U,!0))}Lt!=O&&(f.globalAlpha=Lt=O),Tn("drawSeries",U)}}),v&&(f.globalAlpha=Lt=1)}}function Je(v,T){let U=T?y[v].points:y[v];U._stroke=U.stroke(i,v),U._fill=U.fill(i,v)}function Pe(v,T){let U=T?y[v].points:y[v],{stroke:O,fill:q,clip:j,flags:pt,_stroke:yt=U._stroke,_fill:wt=U._fill,_width:Ft=U.width}=U._paths;Ft=Be(Ft*Ae,3);let Bt=null,kt=Ft%2/2;T&&wt==null&&(wt=Ft>0?"#fff":yt);let se=U.pxAlign==1&&kt>0;if(se&&f.translate(kt,kt),!T){let be=L-Ft/2,Se=w-Ft/2,pe=Z+Ft,jt=xt+Ft;Bt=new Path2D,Bt.rect(be,Se,pe,jt)}T?zt(yt,Ft,U.dash,U.cap,wt,O,q,pt,j):Ie(v,yt,Ft,U.dash,U.cap,wt,O,q,pt,Bt,j),se&&f.translate(-kt,-kt)}function Ie(v,T,U,O,q,j,pt,yt,wt,Ft,Bt){let kt=!1;wt!=0&&R.forEach((se,be)=>{if(se.series[0]==v){let Se=y[se.series[1]],pe=t[se.series[1]],jt=(Se._paths||Fa).band;Js(jt)&&(jt=se.dir==1?jt[0]:jt[1]);let $t,He=null;Se.show&&jt&&Rw(pe,rn,on)?(He=se.fill(i,be)||j,$t=Se._paths.clip):jt=null,zt(T,U,O,q,He,pt,yt,wt,Ft,Bt,$t,jt),kt=!0}}),kt||zt(T,U,O,q,j,pt,yt,wt,Ft,Bt)}let xn=Mo|Df;function zt(v,T,U,O,q,j,pt,yt,wt,Ft,Bt,kt){Rt(v,T,U,O,q),(wt||Ft||kt)&&(f.save(),wt&&f.clip(wt),Ft&&f.clip(Ft)),kt?(yt&xn)==xn?(f.clip(kt),Bt&&f.clip(Bt),ge(q,pt),ln(v,j,T)):yt&Df?(ge(q,pt),f.clip(kt),ln(v,j,T)):yt&Mo&&(f.save(),f.clip(kt),Bt&&f.clip(Bt),ge(q,pt),f.restore(),ln(v,j,T)):(ge(q,pt),ln(v,j,T)),(wt||Ft||kt)&&f.restore()}function ln(v,T,U){U>0&&(T instanceof Map?T.forEach((O,q)=>{f.strokeStyle=Sr=q,f.stroke(O)}):T!=null&&v&&f.stroke(T))}function ge(v,T){T instanceof Map?T.forEach((U,O)=>{f.fillStyle=Ts=O,f.fill(U)}):T!=null&&v&&f.fill(T)}function ns(v,T,U,O){let q=P[v],j;if(O<=0)j=[0,0];else{let pt=q._space=q.space(i,v,T,U,O),yt=q._incrs=q.incrs(i,v,T,U,O,pt);j=JE(T,U,yt,O,pt)}return q._found=j}function cn(v,T,U,O,q,j,pt,yt,wt,Ft){let Bt=pt%2/2;x==1&&f.translate(Bt,Bt),Rt(yt,pt,wt,Ft,yt),f.beginPath();let kt,se,be,Se,pe=q+(O==0||O==3?-j:j);U==0?(se=q,Se=pe):(kt=q,be=pe);for(let jt=0;jt<v.length;jt++)T[jt]!=null&&(U==0?kt=be=v[jt]:se=Se=v[jt],f.moveTo(kt,se),f.lineTo(be,Se));f.stroke(),x==1&&f.translate(-Bt,-Bt)}function br(v){let T=!0;return P.forEach((U,O)=>{if(!U.show)return;let q=S[U.scale];if(q.min==null){U._show&&(T=!1,U._show=!1,le(!1));return}else U._show||(T=!1,U._show=!0,le(!1));let j=U.side,pt=j%2,{min:yt,max:wt}=q,[Ft,Bt]=ns(O,yt,wt,pt==0?V:It);if(Bt==0)return;let kt=q.distr==2,se=U._splits=U.splits(i,O,yt,wt,Ft,Bt,kt),be=q.distr==2?se.map($t=>ti[$t]):se,Se=q.distr==2?ti[se[1]]-ti[se[0]]:Ft,pe=U._values=U.values(i,U.filter(i,be,O,Bt,Se),O,Bt,Se);U._rotate=j==2?U.rotate(i,pe,O,Bt):0;let jt=U._size;U._size=yi(U.size(i,pe,O,v)),jt!=null&&U._size!=jt&&(T=!1)}),T}function Bi(v){let T=!0;return Ao.forEach((U,O)=>{let q=U(i,O,Fi,v);q!=vi[O]&&(T=!1),vi[O]=q}),T}function is(){for(let v=0;v<P.length;v++){let T=P[v];if(!T.show||!T._show)continue;let U=T.side,O=U%2,q,j,pt=T.stroke(i,v),yt=U==0||U==3?-1:1,[wt,Ft]=T._found;if(T.label!=null){let Xn=T.labelGap*yt,ii=Mn((T._lpos+Xn)*Ae);Nt(T.labelFont[0],pt,"center",U==2?"top":sg),f.save(),O==1?(q=j=0,f.translate(ii,Mn(w+xt/2)),f.rotate((U==3?-_h:_h)/2)):(q=Mn(L+Z/2),j=ii);let tr=Yg(T.label)?T.label(i,v,wt,Ft):T.label;f.fillText(tr,q,j),f.restore()}if(Ft==0)continue;let Bt=S[T.scale],kt=O==0?Z:xt,se=O==0?L:w,be=T._splits,Se=Bt.distr==2?be.map(Xn=>ti[Xn]):be,pe=Bt.distr==2?ti[be[1]]-ti[be[0]]:wt,jt=T.ticks,$t=T.border,He=jt.show?jt.size:0,en=Mn(He*Ae),An=Mn((T.alignTo==2?T._size-He-T.gap:T.gap)*Ae),De=T._rotate*-_h/180,nn=g(T._pos*Ae),ei=(en+An)*yt,Wn=nn+ei;j=O==0?Wn:0,q=O==1?Wn:0;let ui=T.font[0],Si=T.align==1?go:T.align==2?yf:De>0?go:De<0?yf:O==0?"center":U==3?yf:go,Vi=De||O==1?"middle":U==2?"top":sg;Nt(ui,pt,Si,Vi);let ni=T.font[1]*T.lineGap,fi=be.map(Xn=>g(a(Xn,Bt,kt,se))),Mi=T._values;for(let Xn=0;Xn<Mi.length;Xn++){let ii=Mi[Xn];if(ii!=null){O==0?q=fi[Xn]:j=fi[Xn],ii=""+ii;let tr=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let qn=0;qn<tr.length;qn++){let gd=tr[qn];De?(f.save(),f.translate(q,j+qn*ni),f.rotate(De),f.fillText(gd,0,0),f.restore()):f.fillText(gd,q,j+qn*ni)}}}jt.show&&cn(fi,jt.filter(i,Se,v,Ft,pe),O,U,nn,en,Be(jt.width*Ae,3),jt.stroke(i,v),jt.dash,jt.cap);let Gi=T.grid;Gi.show&&cn(fi,Gi.filter(i,Se,v,Ft,pe),O,O==0?2:1,O==0?w:L,O==0?xt:Z,Be(Gi.width*Ae,3),Gi.stroke(i,v),Gi.dash,Gi.cap),$t.show&&cn([nn],[1],O==0?1:0,O==0?1:2,O==1?w:L,O==1?xt:Z,Be($t.width*Ae,3),$t.stroke(i,v),$t.dash,$t.cap)}Tn("drawAxes")}function le(v){y.forEach((T,U)=>{U>0&&(T._paths=null,v&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let tn=!1,Hn=!1,Le=[];function hn(){Hn=!1;for(let v=0;v<Le.length;v++)Tn(...Le[v]);Le.length=0}function On(){tn||(Hw(jf),tn=!0)}function za(v,T=!1){tn=!0,Hn=T,v(i),jf(),T&&Le.length>0&&queueMicrotask(hn)}i.batch=za;function jf(){if(dt&&(ue(),dt=!1),bt&&(At(),bt=!1),Mt){if(qe(p,go,Kt),qe(p,"top",oe),qe(p,La,V),qe(p,Da,It),qe(m,go,Kt),qe(m,"top",oe),qe(m,La,V),qe(m,Da,It),qe(h,La,Ne),qe(h,Da,je),u.width=Mn(Ne*Ae),u.height=Mn(je*Ae),P.forEach(({_el:v,_show:T,_size:U,_pos:O,side:q})=>{if(v!=null)if(T){let j=q===3||q===0?U:0,pt=q%2==1;qe(v,pt?"left":"top",O-j),qe(v,pt?"width":"height",U),qe(v,pt?"top":"left",pt?oe:Kt),qe(v,pt?"height":"width",pt?It:V),Cf(v,gr)}else li(v,gr)}),Sr=Ts=Mr=H=et=J=K=Ct=C=null,Lt=1,Lo(!0),Kt!=Tt||oe!=Ue||V!=Wt||It!=Zt){le(!1);let v=V/Wt,T=It/Zt;if(ft&&!ot&&st.left>=0){st.left*=v,st.top*=T,wr&&Qi(wr,Mn(st.left),0,V,It),Er&&Qi(Er,0,Mn(st.top),V,It);for(let U=0;U<ae.length;U++){let O=ae[U];O!=null&&(ke[U]*=v,Gn[U]*=T,Qi(O,yi(ke[U]),yi(Gn[U]),V,It))}}if(Ge.show&&!ct&&Ge.left>=0&&Ge.width>0){Ge.left*=v,Ge.width*=v,Ge.top*=T,Ge.height*=T;for(let U in Uh)qe(Cr,U,Ge[U])}Tt=Kt,Ue=oe,Wt=V,Zt=It}Tn("setSize"),Mt=!1}Ne>0&&je>0&&(f.clearRect(0,0,u.width,u.height),Tn("drawClear"),b.forEach(v=>v()),Tn("draw")),Ge.show&&ct&&(ka(Ge),ct=!1),ft&&ot&&(Qs(null,!0,!1),ot=!1),Q.show&&Q.live&&vt&&(Dh(),vt=!1),l||(l=!0,i.status=1,Tn("ready")),Es=!1,tn=!1}i.redraw=(v,T)=>{bt=T||!1,v!==!1?Cs(M,E.min,E.max):On()};function Ph(v,T){let U=S[v];if(U.from==null){if(Qe==0){let O=U.range(i,T.min,T.max,v);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(Qe>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;v==M&&U.distr==2&&Qe>0&&(T.min=Di(T.min,t[0]),T.max=Di(T.max,t[0]),T.min==T.max&&T.max++),B[v]=T,dt=!0,On()}}i.setScale=Ph;let Ih,Lh,wr,Er,Qf,td,Tr,Ar,ed,nd,Ve,Ye,As=!1,Pn=st.drag,wn=Pn.x,En=Pn.y;ft&&(st.x&&(Ih=xi(dw,m)),st.y&&(Lh=xi(pw,m)),E.ori==0?(wr=Ih,Er=Lh):(wr=Lh,Er=Ih),Ve=st.left,Ye=st.top);let Ge=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Cr=Ge.show?xi(fw,Ge.over?m:p):null;function ka(v,T){if(Ge.show){for(let U in v)Ge[U]=v[U],U in Uh&&qe(Cr,U,v[U]);T!==!1&&Tn("setSelect")}}i.setSelect=ka;function N0(v){if(y[v].show)$&&Cf(nt[v],gr);else if($&&li(nt[v],gr),ft){let U=Pt?ae[0]:ae[v];U!=null&&Qi(U,-10,-10,V,It)}}function Cs(v,T,U){Ph(v,{min:T,max:U})}function zi(v,T,U,O){T.focus!=null&&z0(v),T.show!=null&&y.forEach((q,j)=>{j>0&&(v==j||v==null)&&(q.show=T.show,N0(j),s==2?(Cs(q.facets[0].scale,null,null),Cs(q.facets[1].scale,null,null)):Cs(q.scale,null,null),On())}),U!==!1&&Tn("setSeries",v,T),O&&Do("setSeries",i,v,T)}i.setSeries=zi;function U0(v,T){_n(R[v],T)}function F0(v,T){v.fill=xe(v.fill||null),v.dir=Me(v.dir,-1),T=T??R.length,R.splice(T,0,v)}function O0(v){v==null?R.length=0:R.splice(v,1)}i.addBand=F0,i.setBand=U0,i.delBand=O0;function B0(v,T){y[v].alpha=T,ft&&ae[v]!=null&&(ae[v].style.opacity=T),$&&nt[v]&&(nt[v].style.opacity=T)}let ss,Rs,js,Rr={focus:!0};function z0(v){if(v!=js){let T=v==null,U=Vt.alpha!=1;y.forEach((O,q)=>{if(s==1||q>0){let j=T||q==0||q==v;O._focus=T?null:j,U&&B0(q,j?1:Vt.alpha)}}),js=v,U&&On()}}$&&ee&&me(lg,gt,v=>{st._lock||(te(v),js!=null&&zi(null,Rr,!0,un.setSeries))});function ki(v,T,U){let O=S[T];U&&(v=v/Ae-(O.ori==1?oe:Kt));let q=V;O.ori==1&&(q=It,v=q-v),O.dir==-1&&(v=q-v);let j=O._min,pt=O._max,yt=v/q,wt=j+(pt-j)*yt,Ft=O.distr;return Ft==3?yo(10,wt):Ft==4?Iw(wt,O.asinh):Ft==100?O.bwd(wt):wt}function k0(v,T){let U=ki(v,M,T);return Di(U,t[0],rn,on)}i.valToIdx=v=>Di(v,t[0]),i.posToIdx=k0,i.posToVal=ki,i.valToPos=(v,T,U)=>S[T].ori==0?r(v,S[T],U?Z:V,U?L:0):o(v,S[T],U?xt:It,U?w:0),i.setCursor=(v,T,U)=>{Ve=v.left,Ye=v.top,Qs(null,T,U)};function id(v,T){qe(Cr,go,Ge.left=v),qe(Cr,La,Ge.width=T)}function sd(v,T){qe(Cr,"top",Ge.top=v),qe(Cr,Da,Ge.height=T)}let Po=E.ori==0?id:sd,Io=E.ori==1?id:sd;function V0(){if($&&Q.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&Ot)continue;let T=Q.values[v],U=0;for(let O in T)lt[v][U++].firstChild.nodeValue=T[O]}}function Dh(v,T){if(v!=null&&(v.idxs?v.idxs.forEach((U,O)=>{rt[O]=U}):Uw(v.idx)||rt.fill(v.idx),Q.idx=rt[0]),$&&Q.live){for(let U=0;U<y.length;U++)(U>0||s==1&&!Ot)&&G0(U,rt[U]);V0()}vt=!1,T!==!1&&Tn("setLegend")}i.setLegend=Dh;function G0(v,T){let U=y[v],O=v==0&&N==2?ti:t[v],q;Ot?q=U.values(i,v,T)??Xt:(q=U.value(i,T==null?null:O[T],v,T),q=q==null?Xt:{_:q}),Q.values[v]=q}function Qs(v,T,U){ed=Ve,nd=Ye,[Ve,Ye]=st.move(i,Ve,Ye),st.left=Ve,st.top=Ye,ft&&(wr&&Qi(wr,Mn(Ve),0,V,It),Er&&Qi(Er,0,Mn(Ye),V,It));let O,q=rn>on;ss=Oe,Rs=null;let j=E.ori==0?V:It,pt=E.ori==1?V:It;if(Ve<0||Qe==0||q){O=st.idx=null;for(let yt=0;yt<y.length;yt++){let wt=ae[yt];wt!=null&&Qi(wt,-10,-10,V,It)}ee&&zi(null,Rr,!0,v==null&&un.setSeries),Q.live&&(rt.fill(O),vt=!0)}else{let yt,wt,Ft;s==1&&(yt=E.ori==0?Ve:Ye,wt=ki(yt,M),O=st.idx=Di(wt,t[0],rn,on),Ft=F(t[0][O],E,j,0));let Bt=-10,kt=-10,se=0,be=0,Se=!0,pe="",jt="";for(let $t=s==2?1:0;$t<y.length;$t++){let He=y[$t],en=rt[$t],An=en==null?null:s==1?t[$t][en]:t[$t][1][en],De=st.dataIdx(i,$t,O,wt),nn=De==null?null:s==1?t[$t][De]:t[$t][1][De];if(vt=vt||nn!=An||De!=en,rt[$t]=De,$t>0&&He.show){let ei=De==null?-10:De==O?Ft:F(s==1?t[0][De]:t[$t][0][De],E,j,0),Wn=nn==null?-10:I(nn,s==1?S[He.scale]:S[He.facets[1].scale],pt,0);if(ee&&nn!=null){let ui=E.ori==1?Ve:Ye,Si=bn(Vt.dist(i,$t,De,Wn,ui));if(Si<ss){let Vi=Vt.bias;if(Vi!=0){let ni=ki(ui,He.scale),fi=nn>=0?1:-1,Mi=ni>=0?1:-1;Mi==fi&&(Mi==1?Vi==1?nn>=ni:nn<=ni:Vi==1?nn<=ni:nn>=ni)&&(ss=Si,Rs=$t)}else ss=Si,Rs=$t}}if(vt||Pt){let ui,Si;E.ori==0?(ui=ei,Si=Wn):(ui=Wn,Si=ei);let Vi,ni,fi,Mi,Gi,Xn,ii=!0,tr=_t.bbox;if(tr!=null){ii=!1;let qn=tr(i,$t);fi=qn.left,Mi=qn.top,Vi=qn.width,ni=qn.height}else fi=ui,Mi=Si,Vi=ni=_t.size(i,$t);if(Xn=_t.fill(i,$t),Gi=_t.stroke(i,$t),Pt)$t==Rs&&ss<=Vt.prox&&(Bt=fi,kt=Mi,se=Vi,be=ni,Se=ii,pe=Xn,jt=Gi);else{let qn=ae[$t];qn!=null&&(ke[$t]=fi,Gn[$t]=Mi,mg(qn,Vi,ni,ii),dg(qn,Xn,Gi),Qi(qn,yi(fi),yi(Mi),V,It))}}}}if(Pt){let $t=Vt.prox,He=js==null?ss<=$t:ss>$t||Rs!=js;if(vt||He){let en=ae[0];en!=null&&(ke[0]=Bt,Gn[0]=kt,mg(en,se,be,Se),dg(en,pe,jt),Qi(en,yi(Bt),yi(kt),V,It))}}}if(Ge.show&&As)if(v!=null){let[yt,wt]=un.scales,[Ft,Bt]=un.match,[kt,se]=v.cursor.sync.scales,be=v.cursor.drag;if(wn=be._x,En=be._y,wn||En){let{left:Se,top:pe,width:jt,height:$t}=v.select,He=v.scales[kt].ori,en=v.posToVal,An,De,nn,ei,Wn,ui=yt!=null&&Ft(yt,kt),Si=wt!=null&&Bt(wt,se);ui&&wn?(He==0?(An=Se,De=jt):(An=pe,De=$t),nn=S[yt],ei=F(en(An,kt),nn,j,0),Wn=F(en(An+De,kt),nn,j,0),Po(Ni(ei,Wn),bn(Wn-ei))):Po(0,j),Si&&En?(He==1?(An=Se,De=jt):(An=pe,De=$t),nn=S[wt],ei=I(en(An,se),nn,pt,0),Wn=I(en(An+De,se),nn,pt,0),Io(Ni(ei,Wn),bn(Wn-ei))):Io(0,pt)}else Fh()}else{let yt=bn(ed-Qf),wt=bn(nd-td);if(E.ori==1){let se=yt;yt=wt,wt=se}wn=Pn.x&&yt>=Pn.dist,En=Pn.y&&wt>=Pn.dist;let Ft=Pn.uni;Ft!=null?wn&&En&&(wn=yt>=Ft,En=wt>=Ft,!wn&&!En&&(wt>yt?En=!0:wn=!0)):Pn.x&&Pn.y&&(wn||En)&&(wn=En=!0);let Bt,kt;wn&&(E.ori==0?(Bt=Tr,kt=Ve):(Bt=Ar,kt=Ye),Po(Ni(Bt,kt),bn(kt-Bt)),En||Io(0,pt)),En&&(E.ori==1?(Bt=Tr,kt=Ve):(Bt=Ar,kt=Ye),Io(Ni(Bt,kt),bn(kt-Bt)),wn||Po(0,j)),!wn&&!En&&(Po(0,0),Io(0,0))}if(Pn._x=wn,Pn._y=En,v==null){if(U){if(md!=null){let[yt,wt]=un.scales;un.values[0]=yt!=null?ki(E.ori==0?Ve:Ye,yt):null,un.values[1]=wt!=null?ki(E.ori==1?Ve:Ye,wt):null}Do(vf,i,Ve,Ye,V,It,O)}if(ee){let yt=U&&un.setSeries,wt=Vt.prox;js==null?ss<=wt&&zi(Rs,Rr,!0,yt):ss>wt?zi(null,Rr,!0,yt):Rs!=js&&zi(Rs,Rr,!0,yt)}}vt&&(Q.idx=O,Dh()),T!==!1&&Tn("setCursor")}let Ps=null;Object.defineProperty(i,"rect",{get(){return Ps==null&&Lo(!1),Ps}});function Lo(v=!1){v?Ps=null:(Ps=m.getBoundingClientRect(),Tn("syncRect",Ps))}function rd(v,T,U,O,q,j,pt){st._lock||As&&v!=null&&v.movementX==0&&v.movementY==0||(Nh(v,T,U,O,q,j,pt,!1,v!=null),v!=null?Qs(null,!0,!0):Qs(T,!0,!1))}function Nh(v,T,U,O,q,j,pt,yt,wt){if(Ps==null&&Lo(!1),te(v),v!=null)U=v.clientX-Ps.left,O=v.clientY-Ps.top;else{if(U<0||O<0){Ve=-10,Ye=-10;return}let[Ft,Bt]=un.scales,kt=T.cursor.sync,[se,be]=kt.values,[Se,pe]=kt.scales,[jt,$t]=un.match,He=T.axes[0].side%2==1,en=E.ori==0?V:It,An=E.ori==1?V:It,De=He?j:q,nn=He?q:j,ei=He?O:U,Wn=He?U:O;if(Se!=null?U=jt(Ft,Se)?a(se,S[Ft],en,0):-10:U=en*(ei/De),pe!=null?O=$t(Bt,pe)?a(be,S[Bt],An,0):-10:O=An*(Wn/nn),E.ori==1){let ui=U;U=O,O=ui}}wt&&(T==null||T.cursor.event.type==vf)&&((U<=1||U>=V-1)&&(U=pr(U,V)),(O<=1||O>=It-1)&&(O=pr(O,It))),yt?(Qf=U,td=O,[Tr,Ar]=st.move(i,U,O)):(Ve=U,Ye=O)}let Uh={width:0,height:0,left:0,top:0};function Fh(){ka(Uh,!1)}let od,ad,ld,cd;function hd(v,T,U,O,q,j,pt){As=!0,wn=En=Pn._x=Pn._y=!1,Nh(v,T,U,O,q,j,pt,!0,!1),v!=null&&(me(Sf,Tf,ud,!1),Do(og,i,Tr,Ar,V,It,null));let{left:yt,top:wt,width:Ft,height:Bt}=Ge;od=yt,ad=wt,ld=Ft,cd=Bt}function ud(v,T,U,O,q,j,pt){As=Pn._x=Pn._y=!1,Nh(v,T,U,O,q,j,pt,!1,!0);let{left:yt,top:wt,width:Ft,height:Bt}=Ge,kt=Ft>0||Bt>0,se=od!=yt||ad!=wt||ld!=Ft||cd!=Bt;if(kt&&se&&ka(Ge),Pn.setScale&&kt&&se){let be=yt,Se=Ft,pe=wt,jt=Bt;if(E.ori==1&&(be=wt,Se=Bt,pe=yt,jt=Ft),wn&&Cs(M,ki(be,M),ki(be+Se,M)),En)for(let $t in S){let He=S[$t];$t!=M&&He.from==null&&He.min!=Oe&&Cs($t,ki(pe+jt,$t),ki(pe,$t))}Fh()}else st.lock&&(st._lock=!st._lock,Qs(T,!0,v!=null));v!=null&&(sn(Sf,Tf),Do(Sf,i,Ve,Ye,V,It,null))}function H0(v,T,U,O,q,j,pt){if(st._lock)return;te(v);let yt=As;if(As){let wt=!0,Ft=!0,Bt=10,kt,se;E.ori==0?(kt=wn,se=En):(kt=En,se=wn),kt&&se&&(wt=Ve<=Bt||Ve>=V-Bt,Ft=Ye<=Bt||Ye>=It-Bt),kt&&wt&&(Ve=Ve<Tr?0:V),se&&Ft&&(Ye=Ye<Ar?0:It),Qs(null,!0,!0),As=!1}Ve=-10,Ye=-10,rt.fill(null),Qs(null,!0,!0),yt&&(As=yt)}function fd(v,T,U,O,q,j,pt){st._lock||(te(v),Ro(),Fh(),v!=null&&Do(cg,i,Ve,Ye,V,It,null))}function dd(){P.forEach(KE),k(i.width,i.height,!0)}_r(xh,xo,dd);let Pr={};Pr.mousedown=hd,Pr.mousemove=rd,Pr.mouseup=ud,Pr.dblclick=fd,Pr.setSeries=(v,T,U,O)=>{let q=un.match[2];U=q(i,T,U),U!=-1&&zi(U,O,!0,!1)},ft&&(me(og,m,hd),me(vf,m,rd),me(ag,m,v=>{te(v),Lo(!1)}),me(lg,m,H0),me(cg,m,fd),Nf.add(i),i.syncRect=Lo);let Va=i.hooks=n.hooks||{};function Tn(v,T,U){Hn?Le.push([v,T,U]):v in Va&&Va[v].forEach(O=>{O.call(null,i,T,U)})}(n.plugins||[]).forEach(v=>{for(let T in v.hooks)Va[T]=(Va[T]||[]).concat(v.hooks[T])});let pd=(v,T,U)=>U,un=_n({key:null,setSeries:!1,filters:{pub:vg,sub:vg},scales:[M,y[1]?y[1].scale:null],match:[Sg,Sg,pd],values:[null,null]},st.sync);un.match.length==2&&un.match.push(pd),st.sync=un;let md=un.key,Oh=_0(md);function Do(v,T,U,O,q,j,pt){un.filters.pub(v,T,U,O,q,j,pt)&&Oh.pub(v,T,U,O,q,j,pt)}Oh.sub(i);function W0(v,T,U,O,q,j,pt){un.filters.sub(v,T,U,O,q,j,pt)&&Pr[v](null,T,U,O,q,j,pt)}i.pub=W0;function X0(){Oh.unsub(i),Nf.delete(i),Ke.clear(),Rf(xh,xo,dd),c.remove(),gt?.remove(),Tn("destroy")}i.destroy=X0;function Bh(){Tn("init",n,t),Co(t||n.data,!1),B[M]?Ph(M,B[M]):Ro(),ct=Ge.show&&(Ge.width>0||Ge.height>0),ot=vt=!0,k(n.width,n.height)}return y.forEach(vr),P.forEach(ts),e?e instanceof HTMLElement?(e.appendChild(c),Bh()):e(i,Bh):Bh(),i}Fn.assign=_n;Fn.fmtNum=Vf;Fn.rangeNum=yh;Fn.rangeLog=Mh;Fn.rangeAsinh=zf;Fn.orient=yr;Fn.pxRatio=Ae;Fn.join=Gw;Fn.fmtDate=Hf,Fn.tzDate=Qw;Fn.sync=_0;{Fn.addGap=UE,Fn.clipGaps=Eh;let n=Fn.paths={points:b0};n.linear=E0,n.stepped=BE,n.bars=zE,n.spline=VE}var Jf=30,jE=200,Ui=16384,R0=["#b3261e","#2e7d32","#1652b8","#e07a5f","#66a182","#7aa5e8","#7a1811","#14532d","#0b2e6b","#444","#888","#d81b9a"];function P0(n){let t=Array.from({length:n+1},()=>new Float64Array(Ui)),[e,i]=[0,0];function s(o,a){let l=t[0][(i+Ui-1)%Ui];e&&(o<l||o-l>Jf)&&(e=0),t[0][i]=o;for(let c=0;c<n;c++)t[c+1][i]=a[c];i=(i+1)%Ui,e=Math.min(e+1,Ui)}function r(o){if(!e)return[[],...o.map(()=>[])];let a=t[0][(i+Ui-1)%Ui],l=0;for(;l<e&&a-t[0][(i+Ui-1-l)%Ui]<=Jf;)l+=1;let c=i-l+Ui,u=(h,p)=>Array.from({length:l},(m,x)=>p(h[(c+x)%Ui])),f=h=>Number.isNaN(h)?null:h;return[u(t[0],h=>h-a),...o.map(h=>u(t[h+1],f))]}return{push:s,last:r}}function I0(n,t,e){let i={font:"11px system-ui",size:34,stroke:"#555",grid:{stroke:"#e8e8e2"}},s=t.map((a,l)=>({label:a,stroke:R0[l%R0.length],width:1,points:{show:!1}})),r={width:n.clientWidth||420,height:e,cursor:{show:!1},scales:{x:{time:!1,range:[-Jf,0]}},axes:[i,{...i,size:48}],series:[{label:"s"},...s]},o=new Fn(r,[[],...t.map(()=>[])],n);return new ResizeObserver(()=>o.setSize({width:n.clientWidth,height:e})).observe(n),o}function L0(n,t,e){let i=P0(t.length),s=P0(e.length),r=I0(n("forces"),e.map(h=>`face ${h}`),130);n("face").append(...e.map(h=>new Option(h,h)));let o,a;function l(){let h=n("face").value;o=t.flatMap((p,m)=>p.startsWith(`F${h}-`)?[m]:[]),a?.destroy(),n("channels").replaceChildren(),a=I0(n("channels"),o.map(p=>t[p].slice(3)),170)}n("face").addEventListener("change",l),l();function c({rows:h,wide:p,values:m,timeS:x,contacts:g}){for(let d=0;d<h;d++){let y=d*p;i.push(x+m[y],m.subarray(y+1,y+p))}s.push(x,e.map(d=>g.reduce((y,P)=>P.face===d?y+P.force:y,0)))}let u=0;function f(h){h-u<jE||(u=h,a.setData(i.last(o)),r.setData(s.last(e.map((p,m)=>m))))}return{take:c,draw:f}}var Kf=["good","absent","silent","saturated","dead","noisy","drifting"],QE=1e3,t1=100;async function e1(){let n=R=>document.querySelector(`[data-name="${R}"]`),t=await fetch(`/scene${location.search}`);if(!t.ok)throw new Error(`the server refused the scene (${t.status})`);let e=await er(new Uint8Array(await t.arrayBuffer())),{content:i}=e,{channels:s}=i.live;n("name").textContent=`${i.name}, live`,document.title=`${i.name}, live`,n("key").textContent=i.live.key;let r=Ys(n("canvas"),i.size_mm),o=sh(e,r);r.scene.add(o.root);let a=tg(r,n("overlay"),o.silicone.front.geometry),l=i.faces.map(R=>R.number),c=L0(n,s,l),u=r1(n("health"),s);o.fade(Number(n("opacity").value)/100),n("opacity").addEventListener("input",()=>o.fade(Number(n("opacity").value)/100));let f=eg(),h,p,m,x={},g=0;function d(R){if(requestAnimationFrame(d),m&&f.seen(m),m=null,!p)return;let M=performance.now();a.show(p.contacts,p.labels),R-g>=t1&&(s1(n("contacts"),p.contacts),g=R),c.draw(R),h.readyState===WebSocket.OPEN&&h.send(Uint32Array.of(p.number)),[m,p]=[p,null],f.drawn(performance.now()-M)}function y({data:R}){let M=ng(R,s.length);if(M.state)return P(x=M.state);f.came(M),c.take(M),p=M}function P(R){u.show(R.health??[]);let{recording:M}=R;n("record").setAttribute("aria-pressed",String(!!M?.on)),n("record").textContent=M?.on?"recording":"record",n("record").title=M?.file?`into ${M.file}`:"",n("zero").textContent=R.zeroed?"zero":"zeroing \u2026";let _=[R.told,R.trouble,R.explained===!1?"no contact that the model knows explains these readings":""].filter(Boolean).join("; ");n("trouble").textContent!==_&&(n("trouble").textContent=_),n("told").textContent=i1(R,f.told())}function S(){h=new WebSocket(`ws://${location.host}/stream${location.search}`),h.binaryType="arraybuffer",h.onmessage=y,h.onclose=()=>{n("told").textContent="the server does not answer; what was recorded is kept",setTimeout(S,QE)}}n("zero").addEventListener("click",()=>h.send("zero")),n("record").addEventListener("click",()=>h.send(x.recording?.on?"record off":"record on")),requestAnimationFrame(d),S(),window.instobjLive={figures:()=>({...f.told(),objectDrawn:r.drawn()}),forget:f.forget,state:()=>x,contacts:a.shown,labels:a.told,hidden:a.hidden,pictureMs:()=>n1(r)},document.getElementById("instobj-live").dataset.ready="yes"}function n1(n){let t=n.renderer.getContext(),e=performance.now();return n.draw(),t.readPixels(0,0,1,1,t.RGBA,t.UNSIGNED_BYTE,new Uint8Array(4)),performance.now()-e}function i1(n,t){let{recording:e,counted:i}=n,s=[n.source,`${ws(n.rate_hz,0)} frames/s`];return i&&s.push(`${i.lost} lost, ${i.damaged} damaged lines, ${i.restarts} restarts`),e&&s.push(e.on||e.rows?`${e.rows} rows in ${e.file}${e.unlabelled?`, ${e.unlabelled} frames without a force not written`:""}`:"not recording"),s.push(`${ws(t.perSecond,0)} pictures/s, ${ws(t.latencyMs.p50,0)} ms old (99 %: ${ws(t.latencyMs.p99,0)})`),t.dropped&&s.push(`${t.dropped} frames not shown here`),s.filter(Boolean).join(" \xB7 ")}var ws=(n,t)=>Number.isFinite(n)?n.toFixed(t):"\u2013";function s1(n,t){n.replaceChildren(...t.map(e=>{let i=document.createElement("tr");return[e.face,ws(e.x,1),ws(e.y,1),ws(e.radius,1),`${ws(e.force,2)} \xB1 ${ws(e.halfwidth,2)}`].forEach(r=>i.insertCell().append(String(r).replace("-","\u2212"))),i}))}function r1(n,t){let e=[];for(let s=0;s<t.length;s+=3){let[,r,o]=t[s].match(/^F(\d)-X(\d+)$/),a=n.insertRow();a.insertCell().append(r),a.insertCell().append(o);for(let l=0;l<3;l++)e.push(a.insertCell())}function i(s){s.forEach((r,o)=>{e[o].className!==Kf[r]&&(e[o].className=Kf[r],e[o].textContent=Kf[r])})}return{show:i}}document.getElementById("instobj-live")&&e1().catch(n=>{document.querySelector('[data-name="trouble"]').textContent=`No live view: ${n.message}.`,console.warn(n)});var o1="instobj objects shown",a1={object:Om,layouts:Rm};async function D0(n,t){try{return a1[n.dataset.kind](n,await er(t))}catch(e){return n.hidden=!0,n.parentElement.querySelector(".no-viewer").textContent=`No view in three dimensions: ${e.message}.`,console.warn(e),null}}async function l1(){let n=[...document.querySelectorAll(".viewer[data-scene]")],t=s=>Ga(document.getElementById(s.dataset.scene).textContent),i=(await Promise.all(n.map(s=>D0(s,t(s))))).filter(s=>s?.press);i.length>1&&Lm(i),n.forEach(s=>!s.hidden&&(s.dataset.ready="yes")),requestAnimationFrame(()=>requestAnimationFrame(()=>performance.mark(o1)))}async function c1({model:n,el:t}){t.innerHTML=n.get("markup");let e=n.get("scene"),i=new Uint8Array(e.buffer,e.byteOffset,e.byteLength),s=await D0(t.querySelector(".viewer"),i);s&&(s.host.dataset.ready="yes")}document.querySelector(".viewer[data-scene]")&&requestAnimationFrame(()=>setTimeout(l1));return K0(h1);})();
